#include "app/bench/scene_input.h"

#include "render/scene/scene_file.h"

namespace pdr::bench {

Result<Scene> loadScene(const std::string& path) {
    Result<SceneFile> file = readSceneFile(path);
    if (!file)
        return file.error();
    if (!file->source.dicomFolder.empty())
        return Error{"this program reads raw volumes only", path, "Render DICOM folders with pdrender-cli."};
    Result<std::shared_ptr<const Volume>> volume = fetchRawVolume(file->source);
    if (!volume)
        return volume.error();
    file->scene.volume = *volume;
    return file->scene;
}

}  // namespace pdr::bench
