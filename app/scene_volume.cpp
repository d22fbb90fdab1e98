#include "app/scene_volume.h"

#include <algorithm>
#include <utility>

#include "dicom/import.h"
#include "render/volume/clamp.h"

namespace pdr::app {
namespace {

/// Why nothing of the scan can be loaded, in one sentence per series at most.
Error nothingLoadable(const dicom::ScanResult& scan) {
    std::string reasons;
    for (const dicom::Series& series : scan.series)
        reasons += (reasons.empty() ? "" : "; ") + series.verdict.reason;
    if (reasons.empty() && !scan.problems.empty())
        reasons = scan.problems.front().reason;
    return {"no series here can be loaded" + (reasons.empty() ? "" : ": " + reasons), "",
            "\"pdrender-cli info FOLDER\" lists all of them."};
}

/// Scanning takes the first tenth of the bar, decoding the rest.
Progress part(const Progress& progress, double from, double to) {
    return [&progress, from, to](double fraction, std::string_view step) {
        return progress(from + (to - from) * fraction, step);
    };
}

}  // namespace

Result<dicom::Series> chosenSeries(const dicom::ScanResult& scan, const std::string& id) {
    const auto found = std::find_if(scan.series.begin(), scan.series.end(), [&](const dicom::Series& series) {
        return id.empty() ? series.verdict.loadable() : series.series.id() == id;
    });
    if (found != scan.series.end())
        return *found;
    if (id.empty())
        return nothingLoadable(scan);
    return Error{"there is no series " + id + " here", "", "\"pdrender-cli info FOLDER\" lists those that there are."};
}

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
    return FetchedVolume{std::make_shared<const Volume>(clamped(*std::move(volume), source.clampHu)), std::move(notes)};
}

}  // namespace pdr::app
