#pragma once
/// Runs the warps of a launch, in the order that the settings ask for.

#include <vector>

#include "tests/ptx/machine/warp.h"

namespace pdr::ptx {

/// Runs the launch to its end. `warps`: registers of earlier launches of the same program, to be used again. Throws
/// DeviceFault.
void runLaunch(Launch& launch, std::vector<Warp>& warps);

}  // namespace pdr::ptx
