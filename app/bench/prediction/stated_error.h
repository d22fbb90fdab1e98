#pragma once
/// Whether the error that is shown of a picture holds: of how much tissue, over seeds, against a picture of far more
/// samples.

#include <cstdint>
#include <vector>

#include "render/base/result.h"
#include "render/device/device.h"
#include "render/scene/scene.h"

namespace pdr::bench {

struct StatedError {
    std::uint64_t samples = 0;
    double within = 0;  ///< part of the tissue that lies within the levels stated for 95 % of it, mean over seeds
    int fewBright = 0;  ///< pictures that said that they rest on few bright samples
};

/// Of pictures of `samples`, ascending, of seeds 1, 2, ... `seeds`. `truth`: samples of the picture that they are held
/// against. `exposure`: of the display. Errors: the device's.
Result<std::vector<StatedError>> statedErrors(Scene scene, const std::vector<std::uint64_t>& samples, int seeds,
                                              std::uint32_t truth, float exposure, Device& device);

}  // namespace pdr::bench
