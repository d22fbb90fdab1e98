#pragma once
/// Measured curves of an image's error against its rendering time, and figures that are read off such curves.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/accuracy/bias_estimate.h"
#include "render/accuracy/forecast.h"
#include "render/accuracy/true_error.h"

namespace pdr::app {

/// One measured point of a curve: the state of the image after `samples` samples per pixel.
struct AccuracyStep {
    std::uint64_t samples = 0;  ///< samples per pixel
    double seconds = 0;         ///< rendering time
    TrueError error;
    /// Error that the renderer states without the reference [display levels]; null if it states none.
    std::optional<double> stated = {};
    /// Upper bound of the error of a denoised image [display levels]; null for other images.
    std::optional<double> atMost = {};
    /// Name of the saved PNG file in the report's folder; empty if none was saved.
    std::filesystem::path image = {};
    /// Rendering time until `stated` is reached [s], as predicted when the image had a quarter and a sixteenth of its
    /// samples; null if there was no prediction.
    std::optional<Foretold> foretoldAtQuarter = {}, foretoldAtSixteenth = {};
};

struct AccuracyCurve {
    std::string name;
    std::string bias = {};                          ///< phrase that names the bias; empty if there is none
    std::string missing = {};                       ///< phrase that names what its images may lack; empty if nothing
    std::vector<AccuracyStep> steps = {};           ///< after 1, 2, 4, ... samples per pixel
    std::optional<MeasuredBias> measuredBias = {};  ///< bias against the exact image, measured on a lattice of pixels
};

/// Returns the rendering time after which the error stays at or below `levels` [s], interpolated linearly between the
/// logarithms of the steps. Null if the curve does not reach it.
std::optional<double> secondsToReach(double levels, const AccuracyCurve& curve);

/// Returns the last moment at which the error of `biased` is not above that of `unbiased` [s], within the time that
/// both curves cover. Null if there is none; infinity if it still holds at the end of that time.
std::optional<double> betterUntil(const AccuracyCurve& biased, const AccuracyCurve& unbiased);

}  // namespace pdr::app
