#include "app/bench/load_scene.h"

#include <cstdio>

#include "render/scene/scene_file.h"

namespace pdr::bench {

Result<Scene> loadScene(const std::string& path) {
    Result<SceneFile> file = readSceneFile(path);
    if (!file)
        return file.error();
    if (!file->source.dicomFolder.empty())
        return Error{"this program reads raw volumes only", path, "Render DICOM folders with pdrender-cli."};
    if (file->parts.isGiven())
        return Error{"this program reads no label maps", path, "Render scenes with parts with pdrender-cli."};
    Result<WantedVolume> volume = fetchRawVolume(file->source);
    if (!volume)
        return volume.error();
    file->scene.volume = volume->volume;
    return file->scene;
}

int fail(const Error& error) {
    std::fprintf(stderr, "pdrender-bench: %s\n", error.text().c_str());
    return 1;
}

}  // namespace pdr::bench
