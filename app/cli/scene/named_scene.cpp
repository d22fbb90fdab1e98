#include "app/cli/scene/named_scene.h"

#include <utility>

#include "app/scan/scan_place.h"
#include "render/base/file_ending.h"

namespace pdr::app {

bool isSceneFile(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored) && !isScanFile(path);
}

Result<SceneFile> namedScene(const std::filesystem::path& path, const std::string& seriesUid) {
    SceneFile file;
    if (isSceneFile(path)) {
        if (fileEnding(path) != ".json")
            return Error{"this is a file, but neither a scan nor a scene file (.json)", path.string(),
                         "Give the folder that holds the DICOM files."};
        auto read = readSceneFile(path);
        if (!read)
            return read.error();
        file = *std::move(read);
    } else
        file.source.dicomFolder = path;
    if (!seriesUid.empty() && file.source.dicomFolder.empty())
        return Error{"--series chooses among the series of a DICOM folder, this scene has a raw file", path.string(),
                     "Leave it out."};
    if (!seriesUid.empty())
        file.source.seriesUid = seriesUid;
    return file;
}

}  // namespace pdr::app
