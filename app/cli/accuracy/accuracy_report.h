#pragma once
/// Results of `pdrender-cli accuracy`, and their forms as CSV and JSON. They contain no patient data.

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/accuracy/accuracy_curve.h"
#include "render/film/error/smoothing_judgement.h"

namespace pdr::app {

/// Ways to render one image, all compared with the same reference of many samples.
struct AccuracyImage {
    std::string name;
    std::uint64_t referenceSamples = 0;
    std::optional<DenoisedError> referenceError = {};  ///< stated error of the denoised reference; null if unknown
    /// First the image as it is, second the same image denoised (where it can be), then the other ways.
    std::vector<AccuracyCurve> curves = {};
};

struct AccuracyReport {
    ivec2 size{0};  ///< pixels
    std::string model, device, program;
    std::uint64_t seed = 0;
    AccuracyImage scene;                ///< the requested scene, rendered in each way
    std::vector<AccuracyImage> others;  ///< other images of the same anatomy, see otherImages()
    bool complete = true;               ///< false: the measurement was interrupted
};

/// Errors for which a ladder lists the time [display levels].
inline constexpr double kLadder[] = {32, 16, 8, 4, 2, 1};

/// Returns a CSV table with the columns image, way, samples, seconds, relative error, levels, stated, at most. One
/// line per step; unknown values are empty.
std::string csvText(const AccuracyReport& report);
/// Returns a JSON object: width, height, model, device, program, seed (as text), complete, name, reference, ways,
/// others (each with name, reference, ways). A way has name, bias, missing, measuredBias, steps, and secondsTo, the
/// seconds after which its error is 32, 16, 8, 4, 2 and 1 levels; null where it is not reached.
std::string jsonText(const AccuracyReport& report);
/// Returns the levels that `curve` reached, with their times: "±8 in 1.2 s, ±4 in 5.0 s".
std::string ladderText(const AccuracyCurve& curve);

}  // namespace pdr::app
