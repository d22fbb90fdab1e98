#include "render/timing/frame_time_fit.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "render/base/significance.h"

namespace pdr {

namespace {

constexpr unsigned kAll = 0b1111, kWithoutLaunch = 0b1110;
constexpr int kReweightings = 8;  ///< the weights settle after three or four
constexpr double kOutside = 0.05;

std::array<double, kMostUnknowns> factors(const FrameWork& work) {
    return {double(work.launches()), work.iterations * work.pixels, work.pixels, 1.0};
}

FrameTimeModel modelOf(const Solution& solution) {
    return {solution.unknowns[0], solution.unknowns[1], solution.unknowns[2], solution.unknowns[3]};
}

Result<void> checkEnough(const std::vector<TimedFrame>& frames) {
    std::set<double> sizes;
    std::set<std::uint32_t> counts;
    for (const TimedFrame& frame : frames) {
        if (!(frame.seconds > 0) || !std::isfinite(frame.seconds))
            return Error{phrase("a frame took no time"), "", phrase("Measure for longer.")};
        sizes.insert(frame.work.pixels);
        counts.insert(frame.work.iterations);
    }
    if (sizes.size() < kFitSizes || counts.size() < kFitCounts)
        return Error{
            phrase("too few measurements: %1 sizes with %2 numbers of iterations", sizes.size(), counts.size()), "",
            phrase("Measure at least 5 sizes with 3 numbers of iterations.")};
    return {};
}

bool launchesDiffer(const std::vector<TimedFrame>& frames) {
    return std::ranges::any_of(
        frames, [&](const TimedFrame& frame) { return frame.work.launches() != frames.front().work.launches(); });
}

}  // namespace

Result<FrameTimeFit> FrameTimeFit::of(const std::vector<TimedFrame>& frames) {
    if (const Result<void> enough = checkEnough(frames); !enough)
        return enough.error();
    FrameTimeFit fit;
    fit.launchIsKnown_ = launchesDiffer(frames);
    const unsigned used = fit.launchIsKnown_ ? kAll : kWithoutLaunch;
    // Set up one equation per frame
    std::vector<Equation> equations;
    equations.reserve(frames.size());
    for (const TimedFrame& frame : frames)
        equations.push_back({factors(frame.work), frame.seconds, 1 / frame.seconds});
    // Fit with and without the bounds, and improve the weights
    for (int round = 0; round < kReweightings; ++round) {
        // Weight by the expected time, not by the measured one: otherwise frames that came out short would weigh more
        for (std::size_t i = 0; round > 0 && i < frames.size(); ++i)
            equations[i].weight = 1 / frameSeconds(fit.model_, frames[i].work);
        const std::optional<Solution> bounded = nonNegativeLeastSquares(equations, used);
        const std::optional<Solution> free = leastSquares(equations, used);
        if (!bounded || !free)
            return Error{phrase("the measurements do not tell the parts of a frame's time apart"), "",
                         phrase("Measure more sizes and more numbers of iterations.")};
        fit.model_ = modelOf(*bounded);
        fit.free_ = *free;
    }
    // Estimate the scatter from the residuals
    const int freedom = int(frames.size()) - std::popcount(used);
    fit.scatter_ = std::sqrt(fit.free_.squares / freedom);
    fit.quantile_ = studentT(kOutside, freedom);
    return fit;
}

ConfidenceInterval FrameTimeFit::interval(const Factors& factors, double more) const {
    const Factors bounded{model_.launch, model_.sample, model_.pixel, model_.communication};
    double value = 0, middle = 0, variance = 0;
    for (int i = 0; i < kMostUnknowns; ++i) {
        value += factors[i] * bounded[i];
        middle += factors[i] * free_.unknowns[i];
        for (int j = 0; j < kMostUnknowns; ++j)
            variance += factors[i] * free_.covariance[i][j] * factors[j];
    }
    const double half = quantile_ * std::sqrt(scatter_ * scatter_ * variance + more);
    // Cover both solutions: otherwise an unknown held at 0 by the bounds would seem to be known exactly
    return {std::max(0.0, std::min(middle, value) - half), std::max(middle, value) + half};
}

PredictedFrame FrameTimeFit::predict(const FrameWork& work) const {
    const double seconds = frameSeconds(model_, work), own = scatter_ * seconds;
    return {seconds, interval(factors(work), own * own)};
}

}  // namespace pdr
