#include <algorithm>
#include <cmath>

#include "render/accuracy/forecast.h"

namespace pdr {

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
