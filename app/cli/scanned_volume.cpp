#include "app/cli/scanned_volume.h"

#include <algorithm>
#include <cstdio>

#include "app/cli/progress_line.h"
#include "app/scan/scene_volume.h"
#include "app/scan/series_choice.h"
#include "dicom/import.h"
#include "render/base/file_ending.h"

namespace pdr::app {
namespace {

/// Returns the source of the voxels as they are. Error: those of scene files; a file that is none.
Result<VolumeSource> sourceOf(const std::filesystem::path& path, const std::string& seriesUid) {
    VolumeSource source;
    source.dicomFolder = path;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) {
        if (fileEnding(path) != ".json")
            return Error{"this is a file, but neither a folder nor a scene file (.json)", path.string(),
                         "Give the folder that holds the DICOM files."};
        const auto file = readSceneFile(path);
        if (!file)
            return file.error();
        source = file->source;
    }
    if (!seriesUid.empty() && source.dicomFolder.empty())
        return Error{"--series chooses among the series of a DICOM folder, this scene has a raw file", path.string(),
                     "Leave it out."};
    if (!seriesUid.empty())
        source.seriesUid = seriesUid;
    source.clampHu.reset();
    source.table = Table::shown;
    source.reconstruction = Reconstruction::linear;
    return source;
}

void tellOfOthers(const dicom::ScanResult& scan) {
    const auto loadable = std::ranges::count_if(scan.series, [](const auto& each) { return each.verdict.loadable(); });
    if (loadable > 1)
        std::fprintf(stderr,
                     "note: there are %td series here, and this is the first; --series chooses another, \"pdrender-cli "
                     "info FOLDER\" lists them.\n",
                     loadable);
}

Result<FetchedVolume> fetched(const VolumeSource& source, ProgressLine& line) {
    const Progress progress = [&line](double fraction, std::string_view step) {
        line.show(fraction, step);
        return true;
    };
    if (!source.raw.path.empty())
        return fetchVolume(source, progress);
    const auto scan = dicom::scanFolder(source.dicomFolder, partOf(progress, 0, 0.1));
    if (!scan)
        return scan.error();
    const auto series = chosenSeries(*scan, source.seriesUid);
    if (!series)
        return Error{series.error().what, source.dicomFolder.string(), series.error().hint};
    auto volume = fetchSeries(*series, source, partOf(progress, 0.1, 1));
    line.finish();
    if (volume && source.seriesUid.empty())
        tellOfOthers(*scan);
    return volume;
}

}  // namespace

Result<ScannedVolume> scannedVolume(const std::filesystem::path& path, const std::string& seriesUid) {
    const auto source = sourceOf(path, seriesUid);
    if (!source)
        return source.error();
    ProgressLine line;
    const auto volume = fetched(*source, line);
    line.finish();
    if (!volume)
        return volume.error();
    for (const dicom::Note& note : volume->notes)
        std::fprintf(stderr, "note: %s\n", note.text.c_str());
    return ScannedVolume{volume->wanted.scan, volume->series, {path, source->raw.path}};
}

}  // namespace pdr::app
