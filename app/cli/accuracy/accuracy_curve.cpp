#include "app/cli/accuracy/accuracy_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pdr::app {
namespace {

/// Returns the error at a moment [display levels], interpolated linearly between logarithms. `seconds` lies within the
/// curve.
double levelsAt(double seconds, const AccuracyCurve& curve) {
    const auto after = std::ranges::find_if(curve.steps, [&](const auto& step) { return step.seconds >= seconds; });
    if (after == curve.steps.begin())
        return after->error.levels;
    const AccuracyStep &a = *(after - 1), &b = *after;
    const double share = std::log(seconds / a.seconds) / std::log(b.seconds / a.seconds);
    return a.error.levels * std::pow(b.error.levels / a.error.levels, share);
}

}  // namespace

std::optional<double> secondsToReach(double levels, const AccuracyCurve& curve) {
    auto first = curve.steps.end();
    while (first != curve.steps.begin() && (first - 1)->error.levels <= levels)
        --first;
    if (first == curve.steps.end())
        return std::nullopt;
    if (first == curve.steps.begin() || first->error.levels <= 0)
        return first->seconds;
    const AccuracyStep &a = *(first - 1), &b = *first;
    const double share = std::log(a.error.levels / levels) / std::log(a.error.levels / b.error.levels);
    return a.seconds * std::pow(b.seconds / a.seconds, share);
}

std::optional<double> betterUntil(const AccuracyCurve& biased, const AccuracyCurve& unbiased) {
    if (biased.steps.empty() || unbiased.steps.empty())
        return std::nullopt;
    const double begin = std::max(biased.steps.front().seconds, unbiased.steps.front().seconds);
    const double end = std::min(biased.steps.back().seconds, unbiased.steps.back().seconds);
    constexpr int kMoments = 400;
    std::optional<double> last;
    for (int i = 0; begin < end && i <= kMoments; ++i) {
        const double moment = i == kMoments ? end : begin * std::pow(end / begin, double(i) / kMoments);
        if (levelsAt(moment, biased) <= levelsAt(moment, unbiased))
            last = i == kMoments ? std::numeric_limits<double>::infinity() : moment;
    }
    return last;
}

}  // namespace pdr::app
