#include "app/cli/scanned_volume.h"

#include <cstdio>

#include "app/cli/progress_line.h"
#include "app/scan/scan_place.h"
#include "app/scan/scene_volume.h"
#include "render/base/file_ending.h"

namespace pdr::app {
namespace {

/// Returns the source of the voxels as they are. Error: those of scene files; a file that is none.
Result<VolumeSource> sourceOf(const std::filesystem::path& path, const std::string& seriesUid, Table table) {
    VolumeSource source;
    source.dicomFolder = path;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored) && !isScanFile(path)) {
        if (fileEnding(path) != ".json")
            return Error{"this is a file, but neither a scan nor a scene file (.json)", path.string(),
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
    source.table = table;
    source.reconstruction = Reconstruction::linear;
    return source;
}

}  // namespace

Result<ScannedVolume> scannedVolume(const std::filesystem::path& path, const std::string& seriesUid, Table table,
                                    const std::stop_token& stop) {
    const auto source = sourceOf(path, seriesUid, table);
    if (!source)
        return source.error();
    ProgressLine line;
    const auto volume = fetchVolume(*source, [&](double fraction, std::string_view step) {
        line.show(fraction, step);
        return !stop.stop_requested();
    });
    line.finish();
    if (!volume)
        return volume.error();
    if (source->seriesUid.empty() && volume->loadableSeries > 1)
        std::fprintf(stderr,
                     "note: there are %td series here, and this is the first; --series chooses another, \"pdrender-cli "
                     "info FOLDER\" lists them.\n",
                     volume->loadableSeries);
    for (const dicom::Note& note : volume->notes)
        std::fprintf(stderr, "note: %s\n", note.text.c_str());
    const WantedVolume& wanted = volume->wanted;
    return ScannedVolume{wanted.scan, wanted.volume, wanted.framed.box, volume->series, {path, source->raw.path}};
}

}  // namespace pdr::app
