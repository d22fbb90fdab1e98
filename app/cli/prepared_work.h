#pragma once
/// What the commands that render need before the first sample: a device, perhaps render nodes, and the scene.

#include <functional>
#include <memory>

#include "app/cli/nodes/command_nodes.h"
#include "app/cli/progress_line.h"
#include "app/cli/render/render_options.h"
#include "app/cli/scene/scene_input.h"
#include "render/device/device.h"

namespace pdr::app {

using LoadWork = std::function<Result<LoadedScene>(const Progress&)>;

struct PreparedWork {
    std::unique_ptr<Device> device;
    std::unique_ptr<CommandNodes> crew;  ///< null: no nodes help
    LoadedScene loaded;
};

/// Checks that the outputs can be written, opens the device, connects the render nodes, and loads the scene, with
/// progress and notes for the user. Errors: those of each step; an output would overwrite what the scene was read from.
Result<PreparedWork> prepareWork(const RenderOptions& options, const LoadWork& load, ProgressLine& line,
                                 const std::stop_token& stop);

}  // namespace pdr::app
