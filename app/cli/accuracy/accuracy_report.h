#pragma once
/// What `pdrender-cli accuracy` found, as one page, as a table and as JSON. Nothing of the patient is in it.

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/accuracy/accuracy_curve.h"
#include "render/film/error/smoothing_judgement.h"

namespace pdr::app {

/// Ways to one picture, all compared with the same one of many samples.
struct AccuracyPicture {
    std::string name;
    std::uint64_t referenceSamples = 0;
    std::optional<SmoothedError> referenceError = {};  ///< what is said of it, smoothed
    std::vector<AccuracyCurve> curves = {};  ///< the first is the picture as it is, the second the same, smoothed
};

struct AccuracyReport {
    ivec2 size{0};  ///< pixels
    std::string model, device, program;
    std::uint64_t seed = 0;
    AccuracyPicture scene;                ///< as it is, and each way that it can be made in
    std::vector<AccuracyPicture> others;  ///< of the same anatomy: see otherPictures()
    bool complete = true;                 ///< false: it was interrupted
};

/// Errors in display levels that a ladder tells the time of.
inline constexpr double kLadder[] = {32, 16, 8, 4, 2, 1};

/// Columns: way, samples, seconds, relative error, levels, stated, at most. A line each step; nothing where unknown.
std::string csvText(const AccuracyReport& report);
/// An object: width, height, model, device, seed (as text), reference, ways, others: each with name, reference, ways. A
/// way has name, bias, missing, measuredBias, steps, and secondsTo, the seconds after which its error is 32, 16, 8, 4,
/// 2 and 1 levels; null where it is not reached.
std::string jsonText(const AccuracyReport& report);
/// "±8 in 1.2 s, ±4 in 5.0 s": those that `curve` reached.
std::string ladderText(const AccuracyCurve& curve);

}  // namespace pdr::app
