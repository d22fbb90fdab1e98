#pragma once
/// Scene files: JSON, "format": "pdrender-scene", "version": 1; every field is described in resources/manual/scene-file.md.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "render/base/result.h"
#include "render/scene/scene.h"

namespace pdr {

/// Where the voxels of a scene come from: a DICOM folder or a raw file.
struct VolumeSource {
    std::filesystem::path dicomFolder;  ///< empty for a raw file
    std::string seriesUid;              ///< empty: the first loadable series
    std::filesystem::path rawFile;
    ivec3 size{0};
    dvec3 spacingMm{1};
    std::optional<dvec3> originMm;  ///< centre of voxel (0,0,0); default half a spacing
    std::optional<std::pair<int, int>> clampHu;
};

/// A scene whose voxels are still to be fetched (scene.volume is null).
struct SceneFile {
    VolumeSource source;
    Scene scene;
};

/// Relative paths in the file are taken from the file's folder. Unknown, missing or out-of-range fields are errors that
/// name the field and its range.
Result<SceneFile> readSceneFile(const std::filesystem::path& path);

}  // namespace pdr
