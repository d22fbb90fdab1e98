#include "app/scan/scene_volume.h"

#include <algorithm>
#include <utility>

#include "app/scan/scan_place.h"
#include "app/scan/series_choice.h"

namespace pdr::app {

/// Decoding takes most of the time, so it gets 90 % of the progress.
Result<FetchedVolume> fetchSeries(const dicom::Series& series, const VolumeSource& source, const Progress& progress) {
    std::vector<dicom::Note> notes = series.verdict.notes;
    auto volume = loadVoxels(series, dicom::Padding::maskAsAir, partOf(progress, 0, 0.9), &notes);
    if (!volume)
        return volume.error();
    auto wanted = asWanted(*std::move(volume), source, partOf(progress, 0.9, 1));
    if (!wanted)
        return wanted.error();
    return FetchedVolume{*std::move(wanted), std::move(notes), std::make_shared<const dicom::Series>(series)};
}

Result<FetchedVolume> fetchVolume(const VolumeSource& source, const Progress& progress) {
    if (!source.raw.path.empty()) {
        auto raw = fetchRawVolume(source, progress);
        if (!raw)
            return raw.error();
        return FetchedVolume{*std::move(raw), {}, {}};
    }
    const auto scan = scanPlace(source.dicomFolder, partOf(progress, 0, 0.1));
    if (!scan)
        return scan.error();
    const auto series = chosenSeries(*scan, source.seriesUid);
    if (!series)
        return Error{series.error().what, source.dicomFolder.string(), series.error().hint};
    auto fetched = fetchSeries(*series, source, partOf(progress, 0.1, 1));
    if (fetched)
        fetched->loadableSeries = std::ranges::count_if(scan->series, isShownUnasked);
    return fetched;
}

}  // namespace pdr::app
