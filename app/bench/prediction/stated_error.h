#pragma once
/// Measures whether the stated error of an image holds: for how much of the tissue, over many seeds, compared with an
/// image of far more samples.

#include <cstdint>
#include <vector>

#include "render/base/result.h"
#include "render/device/device.h"
#include "render/scene/scene.h"

namespace pdr::bench {

struct StatedError {
    std::uint64_t samples = 0;
    double within = 0;  ///< fraction of the tissue within the levels stated for 95 % of it, mean over seeds
    int fewBright = 0;  ///< number of images that reported few bright samples
};

/// Returns the results for images of `samples` per pixel, ascending, with seeds 1, 2, ... `seeds`. `truth`: samples per
/// pixel of the reference. `exposure`: that of the display. Errors: those of the device.
Result<std::vector<StatedError>> statedErrors(Scene scene, const std::vector<std::uint64_t>& samples, int seeds,
                                              std::uint32_t truth, float exposure, Device& device);

}  // namespace pdr::bench
