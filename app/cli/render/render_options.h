#pragma once
/// Options of the commands that render.

#include <QStringList>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/batch/share.h"
#include "app/cli/nodes/command_nodes.h"
#include "app/cli/scene/scene_input.h"
#include "render/base/result.h"
#include "render/session/batch_render.h"
#include "ui/annotation/annotations.h"

namespace pdr::app {

struct RenderOptions {
    SceneInput scene;
    std::vector<std::filesystem::path> outputs;   ///< at least one; each .png or .exr, or of a share one .film
    std::optional<Share> share;                   ///< none: the whole image
    Stops stops;                                  ///< 256 samples per pixel by default
    std::string device = "auto";                  ///< name as openDevice() takes it
    int threads = 0;                              ///< 0 = one per core
    NodesWanted nodes;                            ///< other machines that help
    bool denoised = false;                        ///< PNG files are denoised
    ui::Annotate annotate = ui::Annotate::sides;  ///< annotations over PNG files
    bool json = false;
    bool help = false;
};

/// Options of `pdrender-cli merge`.
struct MergeOptions {
    std::vector<std::filesystem::path> films;  ///< at least one
    std::filesystem::path film;                ///< file for all of them as one film; empty: images are made of them
    RenderOptions render;                      ///< scene and outputs of the images; its stops are not used
    bool help = false;
};

/// Options of `pdrender-cli effects`.
struct EffectsOptions {
    SceneInput scene;
    int threads = 0;  ///< 0 = one per core
    bool json = false;
    bool help = false;
};

/// Options of `pdrender-cli accuracy`.
struct AccuracyOptions {
    SceneInput scene;
    std::filesystem::path folder;  ///< folder for the report
    double seconds = 0;            ///< total rendering time
    std::string device = "auto";
    int threads = 0;  ///< 0 = one per core
    bool help = false;
};

/// Options of `pdrender-cli replay`.
struct ReplayOptions {
    SceneInput scene;
    ivec2 pixel{0};
    std::uint64_t sample = 0;
    bool help = false;
};

/// Parses `arguments`, those after the word `render`. Errors are usage errors and name the option in `where`.
Result<RenderOptions> renderOptions(const QStringList& arguments);

/// Parses the arguments after the word `merge`, with the same errors.
Result<MergeOptions> mergeOptions(const QStringList& arguments);

/// Parses the arguments after the words `accuracy`, `effects` and `replay`, with the same errors.
Result<AccuracyOptions> accuracyOptions(const QStringList& arguments);
Result<EffectsOptions> effectsOptions(const QStringList& arguments);
Result<ReplayOptions> replayOptions(const QStringList& arguments);

/// Returns the text for --help.
std::string renderHelp();
std::string mergeHelp();
std::string accuracyHelp();
std::string effectsHelp();
std::string replayHelp();

}  // namespace pdr::app
