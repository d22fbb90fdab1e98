#pragma once
/// What `pdrender-cli render` was asked for.

#include <QStringList>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/batch_render.h"
#include "render/base/result.h"
#include "render/scene/camera.h"
#include "render/scene/preset.h"

namespace pdr::app {

struct RenderOptions {
    std::filesystem::path input;                 ///< a DICOM folder or a scene file
    std::vector<std::filesystem::path> outputs;  ///< at least one; each .png or .exr
    std::string seriesUid;                       ///< empty: the first that can be loaded
    std::optional<Preset> preset;                ///< absent: CT bone for a folder, the file's own look for a scene
    std::optional<StandardView> view;            ///< absent: anterior for a folder, the file's own camera for a scene
    std::optional<ivec2> size;                   ///< absent: 1024 x 1024 for a folder, the file's own film for a scene
    Stops stops;                                 ///< 256 samples when nothing was asked for
    std::optional<double> exposure;
    int threads = 0;  ///< 0 = one per core
    std::optional<std::uint64_t> seed;
    bool json = false;
    bool help = false;
};

/// `arguments` are those after the word `render`. An error is one of usage and names the option in `where`.
Result<RenderOptions> renderOptions(const QStringList& arguments);

/// The text for --help.
std::string renderHelp();

}  // namespace pdr::app
