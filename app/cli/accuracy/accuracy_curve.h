#pragma once
/// What a picture's accuracy costs in time, measured: ways to make it, each on its way to the truth.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "render/accuracy/true_error.h"
#include "render/device/device.h"
#include "render/scene/scene.h"

namespace pdr::app {

/// A picture on its way.
struct AccuracyStep {
    std::uint64_t samples = 0;  ///< per pixel
    double seconds = 0;         ///< of rendering
    TrueError error;
    std::optional<double> stated;   ///< levels that are said of it without the reference; nothing while none are
    std::optional<double> atMost;   ///< of a smoothed picture: their bound
    std::filesystem::path picture;  ///< PNG; empty: none was kept
};

struct AccuracyCurve {
    std::string name;
    std::string bias;                 ///< what never averages out, a phrase; empty: nothing
    std::vector<AccuracyStep> steps;  ///< at 1, 2, 4, ... samples
};

/// Seconds after which the error is `levels` for good, between steps along a line in logarithms. Nothing: not reached.
std::optional<double> secondsToReach(double levels, const AccuracyCurve& curve);

/// Until when a biased way is the better one: the last moment at which its error is not above that of `unbiased`,
/// within the time that both took. Nothing: it never is. Infinite: it still is.
std::optional<double> betterUntil(const AccuracyCurve& biased, const AccuracyCurve& unbiased);

/// A way to make the picture: the scene, changed.
struct AccuracyWay {
    std::string name, bias;
    Scene scene;
};
/// What `scene` allows, itself first.
std::vector<AccuracyWay> accuracyWays(const Scene& scene);

struct AccuracyPlan {
    double seconds;  ///< of rendering, for each way
    Display display;
    std::filesystem::path folder;  ///< for the pictures of the first way; it exists
};

/// Called with what is being done, and how far it is, [0, 1].
using AccuracyProgress = std::function<void(double, const std::string&)>;

/// Renders `way` for plan.seconds at most and compares it with `reference`: its picture as it is, and smoothed where
/// the way has no bias. After a stop request it ends with the step that it has. Errors: the device's, and of files.
Result<std::vector<AccuracyCurve>> measureAccuracy(const AccuracyWay& way, const Film& reference,
                                                   const AccuracyPlan& plan, Device& device,
                                                   const std::stop_token& stop, const AccuracyProgress& progress);

/// A film of `scene` with the next seed, of as many samples as fit `seconds`; at least 2 unless stopped.
Result<std::shared_ptr<const Film>> referenceFor(const Scene& scene, double seconds, Device& device,
                                                 const std::stop_token& stop, const AccuracyProgress& progress);

}  // namespace pdr::app
