#pragma once
/// What `pdrender-cli render` and `pdrender-cli effects` were asked for.

#include <QStringList>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/scene_input.h"
#include "render/base/result.h"
#include "render/session/batch_render.h"

namespace pdr::app {

struct RenderOptions {
    SceneInput scene;
    std::vector<std::filesystem::path> outputs;  ///< at least one; each .png or .exr
    Stops stops;                                 ///< 256 samples when nothing was asked for
    std::string device = "auto";                 ///< as openDevice() takes it
    int threads = 0;                             ///< 0 = one per core
    bool smoothed = false;                       ///< PNG files
    bool json = false;
    bool help = false;
};

/// What `pdrender-cli effects` was asked for.
struct EffectsOptions {
    SceneInput scene;
    int threads = 0;  ///< 0 = one per core
    bool json = false;
    bool help = false;
};

/// What `pdrender-cli replay` was asked for.
struct ReplayOptions {
    SceneInput scene;
    ivec2 pixel{0};
    std::uint64_t sample = 0;
    bool help = false;
};

/// `arguments` are those after the word `render`. An error is one of usage and names the option in `where`.
Result<RenderOptions> renderOptions(const QStringList& arguments);

/// The same for the words `effects` and `replay`.
Result<EffectsOptions> effectsOptions(const QStringList& arguments);
Result<ReplayOptions> replayOptions(const QStringList& arguments);

/// The texts for --help.
std::string renderHelp();
std::string effectsHelp();
std::string replayHelp();

}  // namespace pdr::app
