#pragma once
/// How the error of a picture fell with the time that it took, measured; and what is read off such curves.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/accuracy/bias_estimate.h"
#include "render/accuracy/forecast.h"
#include "render/accuracy/true_error.h"

namespace pdr::app {

/// A picture on its way.
struct AccuracyStep {
    std::uint64_t samples = 0;  ///< per pixel
    double seconds = 0;         ///< of rendering
    TrueError error;
    std::optional<double> stated = {};   ///< levels that are said of it without the reference; nothing while none are
    std::optional<double> atMost = {};   ///< of a smoothed picture: their bound
    std::filesystem::path picture = {};  ///< PNG; empty: none was kept
    /// When `stated` would be reached [s], as was foretold with a quarter and with a sixteenth of the samples; nothing
    /// where nothing was.
    std::optional<Foretold> foretoldAtQuarter = {}, foretoldAtSixteenth = {};
};

struct AccuracyCurve {
    std::string name;
    std::string bias = {};                          ///< what never averages out, a phrase; empty: nothing
    std::string missing = {};                       ///< what may not be seen in its pictures, likewise
    std::vector<AccuracyStep> steps = {};           ///< at 1, 2, 4, ... samples
    std::optional<MeasuredBias> measuredBias = {};  ///< against the exact picture, on a lattice of pixels
};

/// Seconds after which the error is `levels` for good, between steps along a line in logarithms. Nothing: not reached.
std::optional<double> secondsToReach(double levels, const AccuracyCurve& curve);

/// Until when a biased way is the better one: the last moment at which its error is not above that of `unbiased`,
/// within the time that both took. Nothing: it never is. Infinite: it still is.
std::optional<double> betterUntil(const AccuracyCurve& biased, const AccuracyCurve& unbiased);

}  // namespace pdr::app
