#include <algorithm>
#include <cmath>
#include <limits>

#include "render/accuracy/forecast.h"

namespace pdr {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// Returns y at x on the line through both points, in logarithms of both coordinates.
double onLine(double x, double x0, double y0, double x1, double y1) {
    const double part = x1 == x0 ? 0 : std::log(x / x0) / std::log(x1 / x0);
    return y0 * std::pow(y1 / y0, part);
}

/// Returns the index of the first of the two steps between which a value lies; beyond all steps, that of the outermost
/// two. `isBeyond`: whether the value lies beyond a step, towards the finer ones.
template <class IsBeyond>
std::size_t intervalOf(const std::vector<QualityStep>& steps, const IsBeyond& isBeyond) {
    std::size_t i = 0;
    while (i + 2 < steps.size() && isBeyond(steps[i + 1]))
        ++i;
    return i;
}

}  // namespace

bool QualityStep::atLeast() const {
    return std::isinf(seconds.high);
}

const QualityStep* reachedStep(const std::vector<QualityStep>& steps) {
    const auto next = std::find_if(steps.begin(), steps.end(), [](const QualityStep& step) { return !step.reached; });
    return next == steps.begin() ? nullptr : &*(next - 1);
}

const QualityStep* nextStep(const std::vector<QualityStep>& steps) {
    const auto next = std::find_if(steps.begin(), steps.end(), [](const QualityStep& step) { return !step.reached; });
    return next == steps.end() ? nullptr : &*next;
}

std::optional<Foretold> secondsAt(const std::vector<QualityStep>& steps, double levels) {
    if (steps.size() < 2)
        return std::nullopt;
    const std::size_t i = intervalOf(steps, [&](const QualityStep& step) { return levels < step.levels; });
    const QualityStep &a = steps[i], &b = steps[i + 1];
    const auto at = [&](double Foretold::*part) {
        return onLine(levels, a.levels, a.seconds.*part, b.levels, b.seconds.*part);
    };
    return Foretold{at(&Foretold::value), at(&Foretold::low), b.atLeast() ? kUnknown : at(&Foretold::high)};
}

double levelsAt(const std::vector<QualityStep>& steps, double seconds) {
    const std::size_t i = intervalOf(steps, [&](const QualityStep& step) { return seconds > step.seconds.value; });
    const QualityStep &a = steps[i], &b = steps[i + 1];
    return onLine(seconds, a.seconds.value, a.levels, b.seconds.value, b.levels);
}

}  // namespace pdr
