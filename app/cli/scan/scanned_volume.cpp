#include "app/cli/scan/scanned_volume.h"

#include <cstdio>

#include "app/cli/progress_line.h"
#include "app/cli/scene/named_scene.h"
#include "app/scan/scene_volume.h"

namespace pdr::app {
namespace {

/// Returns the source of the voxels as they are. Errors: those of namedScene().
Result<VolumeSource> sourceOf(const std::filesystem::path& path, const std::string& seriesUid, Table table) {
    const Result<SceneFile> file = namedScene(path, seriesUid);
    if (!file)
        return file.error();
    VolumeSource source = file->source;
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
    const auto volume = fetchVolume(*source, line.until(stop));
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
