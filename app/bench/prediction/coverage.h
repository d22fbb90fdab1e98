#pragma once
/// Measures whether forecasts come true: the predicted samples until an early image reaches a fraction of its error,
/// over many seeds.

#include <cstdint>
#include <span>
#include <vector>

#include "render/base/result.h"
#include "render/device/device.h"
#include "render/scene/scene.h"

namespace pdr::bench {

/// Start and target of a prediction.
struct Prediction {
    std::uint64_t samples = 64;  ///< least samples per pixel of the image that predicts
    double part = 0.6;           ///< target, as a fraction of the error of that image; (0, 1)
};

struct PredictionTally {
    std::vector<double> ratios;  ///< predicted over needed samples, one per seed
    int seeds = 0;
    int within = 0;     ///< seeds that needed a number of samples within the interval
    int notBefore = 0;  ///< seeds that needed at least the lower end of the interval
    int atLeast = 0;    ///< seeds whose prediction was only a lower bound ("at least")
};

/// Returns a tally for each prediction of `asked`. Renders the seeds 1, 2, ... `seeds`, each until all errors are
/// reached, at most to twice the end of an interval. `exposure`: that of the display. Errors: those of the device.
Result<std::vector<PredictionTally>> talliesOf(Scene scene, std::span<const Prediction> asked, int seeds,
                                               float exposure, Device& device);

}  // namespace pdr::bench
