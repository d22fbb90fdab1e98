#pragma once
/// `pdrender-cli render --share`: takes the samples of one share of an image.

#include "app/cli/prepared_work.h"
#include "app/program/interrupt.h"

namespace pdr::app {

/// Renders options.share of what `load` loads, to options.stops.samples, and writes its film to the only output.
/// Returns the exit code: 1 after an interrupt, too, which leaves no file.
int renderShare(const RenderOptions& options, const LoadWork& load, const Interrupt& interrupt);

}  // namespace pdr::app
