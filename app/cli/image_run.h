#pragma once
/// The road from a scene to image files that all commands take which render for good.

#include <functional>

#include "app/cli/render_options.h"
#include "app/cli/render_report.h"
#include "app/cli/scene_input.h"
#include "app/program/interrupt.h"

namespace pdr::app {

struct ImageRun {
    std::function<Result<LoadedScene>(const Progress&)> load;  ///< loads what is rendered
    std::function<void(const RenderReport&)> say;              ///< prints what came of it
};

/// Checks the outputs, opens the device, loads the scene, renders it until a stop, and writes the images.
/// `options.scene` names the input in messages alone. Returns the exit code: 1 after an interrupt, too, and if a file
/// is not in its place.
int renderImages(const RenderOptions& options, const ImageRun& run, const Interrupt& interrupt);

}  // namespace pdr::app
