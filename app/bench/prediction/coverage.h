#pragma once
/// Whether forecasts come true: from a young picture, how many samples it takes to a part of its error; over seeds.

#include <cstdint>
#include <span>
#include <vector>

#include "render/base/result.h"
#include "render/device/device.h"
#include "render/scene/scene.h"

namespace pdr::bench {

/// From where to where.
struct Prediction {
    std::uint64_t samples = 64;  ///< of the picture that foretells, at least
    double part = 0.6;           ///< of its error, to be reached; (0, 1)
};

struct PredictionTally {
    std::vector<double> ratios;  ///< foretold over needed samples, seed by seed
    int seeds = 0;
    int within = 0;     ///< that needed what lies in the interval
    int notBefore = 0;  ///< that needed no less than its lower end
    int atLeast = 0;    ///< that said "at least"
};

/// Of each prediction that is asked for. Seeds 1, 2, ... `seeds`, each on until all errors are reached, at most to
/// twice the end of an interval. `exposure`: of the display. Errors: the device's.
Result<std::vector<PredictionTally>> talliesOf(Scene scene, std::span<const Prediction> asked, int seeds,
                                               float exposure, Device& device);

}  // namespace pdr::bench
