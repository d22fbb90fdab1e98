#pragma once
/// What the path on a command line names, where it may be a scan or a scene file.

#include <filesystem>
#include <string>

#include "render/base/result.h"
#include "render/scene/scene_file.h"

namespace pdr::app {

/// Returns whether `path` is a file other than a scan: a scene file, or nothing that can be used.
bool isSceneFile(const std::filesystem::path& path);

/// Reads the scene file `path`; for a scan, returns a scene whose source it is. `seriesUid`: the series of --series;
/// empty: none is named. Errors: a file that is neither; --series for a raw file; those of readSceneFile().
Result<SceneFile> namedScene(const std::filesystem::path& path, const std::string& seriesUid);

}  // namespace pdr::app
