#pragma once
/// What the commands that render were asked for.

#include <QStringList>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/node_crew.h"
#include "app/cli/scene_input.h"
#include "render/base/result.h"
#include "render/session/batch_render.h"
#include "ui/annotation/annotations.h"

namespace pdr::app {

struct RenderOptions {
    SceneInput scene;
    std::vector<std::filesystem::path> outputs;   ///< at least one; each .png or .exr
    Stops stops;                                  ///< 256 samples when nothing was asked for
    std::string device = "auto";                  ///< as openDevice() takes it
    int threads = 0;                              ///< 0 = one per core
    NodesWanted nodes;                            ///< other machines that help
    bool smoothed = false;                        ///< PNG files
    ui::Annotate annotate = ui::Annotate::sides;  ///< PNG files
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

/// What `pdrender-cli accuracy` was asked for.
struct AccuracyOptions {
    SceneInput scene;
    std::filesystem::path folder;  ///< for the report
    double seconds = 0;            ///< of rendering, in all
    std::string device = "auto";
    int threads = 0;  ///< 0 = one per core
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

/// The same for the words `accuracy`, `effects` and `replay`.
Result<AccuracyOptions> accuracyOptions(const QStringList& arguments);
Result<EffectsOptions> effectsOptions(const QStringList& arguments);
Result<ReplayOptions> replayOptions(const QStringList& arguments);

/// The texts for --help.
std::string renderHelp();
std::string accuracyHelp();
std::string effectsHelp();
std::string replayHelp();

}  // namespace pdr::app
