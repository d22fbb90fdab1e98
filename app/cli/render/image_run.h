#pragma once
/// The road from a scene to image files that all commands take which render for good.

#include <functional>

#include "app/cli/prepared_work.h"
#include "app/cli/render/render_options.h"
#include "app/cli/render/render_report.h"
#include "app/output/final_image.h"
#include "app/program/interrupt.h"

namespace pdr::app {

struct ImageRun {
    LoadWork load;                                 ///< loads what is rendered
    std::function<void(const RenderReport&)> say;  ///< prints what came of it
    /// Returns the film that other machines have taken of it; empty: the device takes one.
    std::function<Result<TakenFilm>(const LoadedScene&, Device&)> taken = {};
};

/// Checks the outputs, opens the device, loads the scene, renders it until a stop unless its film has been taken, and
/// writes the images.
/// `options.scene` names the input in messages alone. Returns the exit code: 1 after an interrupt, too, and if a file
/// is not in its place.
int renderImages(const RenderOptions& options, const ImageRun& run, const Interrupt& interrupt);

}  // namespace pdr::app
