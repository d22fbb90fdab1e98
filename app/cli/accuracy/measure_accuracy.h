#pragma once
/// Measures what a picture's accuracy costs in time, against a picture of many more samples.

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "app/cli/accuracy/accuracy_curve.h"
#include "app/cli/accuracy/accuracy_ways.h"
#include "app/cli/accuracy/kept_film.h"
#include "render/device/device.h"

namespace pdr::app {

struct AccuracyPlan {
    double seconds;  ///< of rendering, for each way
    Display display;
    std::filesystem::path folder;  ///< for pictures; it exists. Empty: none are kept
    std::string device = {};       ///< its name, for these
};

/// Called with what is being done, and how far it is, [0, 1].
using AccuracyProgress = std::function<void(double, const std::string&)>;

/// Renders `way` for plan.seconds at most and compares it with `reference`: its picture as it is, and smoothed where
/// the way has no bias and its pictures have noise. The bias of another is measured besides. After a stop request it
/// ends with the step that it has. Errors: the device's, and of files.
Result<std::vector<AccuracyCurve>> measureAccuracy(const AccuracyWay& way, const Film& reference,
                                                   const AccuracyPlan& plan, Device& device,
                                                   const std::stop_token& stop, const AccuracyProgress& progress);

/// `scene` as its references are made: exactly, and with the next seed.
Scene referenceScene(Scene scene);
/// A film of `scene`, of as many samples as fit `seconds` in all; at least 2 unless stopped. It goes on from `before`,
/// where that is not nothing.
Result<KeptFilm> referenceFor(const Scene& scene, double seconds, const std::optional<KeptFilm>& before, Device& device,
                              const std::stop_token& stop, const AccuracyProgress& progress);

}  // namespace pdr::app
