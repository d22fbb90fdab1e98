#include "app/scene_volume.h"

#include <utility>

#include "app/series_choice.h"
#include "dicom/import.h"

namespace pdr::app {
namespace {

/// Scanning takes the first tenth of the bar, decoding the rest.
Progress part(const Progress& progress, double from, double to) {
    return [&progress, from, to](double fraction, std::string_view step) {
        return progress(from + (to - from) * fraction, step);
    };
}

}  // namespace

Result<FetchedVolume> fetchVolume(const VolumeSource& source, const Progress& progress) {
    if (!source.raw.path.empty()) {
        auto raw = fetchRawVolume(source);
        if (!raw)
            return raw.error();
        return FetchedVolume{*std::move(raw), {}};
    }
    const auto scan = dicom::scanFolder(source.dicomFolder, part(progress, 0, 0.1));
    if (!scan)
        return scan.error();
    const auto series = chosenSeries(*scan, source.seriesUid);
    if (!series)
        return Error{series.error().what, source.dicomFolder.string(), series.error().hint};
    std::vector<dicom::Note> notes = series->verdict.notes;
    auto volume = dicom::loadSeries(*series, dicom::Padding::maskAsAir, part(progress, 0.1, 1), &notes);
    if (!volume)
        return volume.error();
    return FetchedVolume{std::make_shared<const Volume>(asWanted(*std::move(volume), source)), std::move(notes)};
}

}  // namespace pdr::app
