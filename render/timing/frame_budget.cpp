#include "render/timing/frame_budget.h"

#include <algorithm>
#include <cmath>

#include "render/timing/iterations.h"

namespace pdr {

namespace {

/// Largest growth of n from a measured frame to the next, because few iterations tell little.
constexpr std::uint32_t kGrowth = 4;

}  // namespace

FrameBudget FrameBudget::clamped() const {
    return {automatic, int(allowedIterations(iterations)), std::clamp(framesPerSecond, 0.1, 60.0),
            std::clamp(efficiency, 0.01, 0.9999)};
}

void FrameTimer::addFrame(std::uint32_t n, double iterationSeconds, double displaySeconds) {
    iterationSeconds_.add(iterationSeconds / n);
    displaySeconds_.add(displaySeconds);
    lastMeasured_ = n;
    addPeriod(n, iterationSeconds + displaySeconds);
}

void FrameTimer::addPeriod(std::uint32_t n, double seconds) {
    if (seconds > 0)
        rates_.add(n / seconds);
}

bool FrameTimer::settled() const {
    return displaySeconds_.full();
}

std::uint32_t FrameTimer::iterations(const FrameBudget& pace) const {
    if (!pace.automatic)
        return std::uint32_t(pace.iterations);
    const double iteration = iterationSeconds_.median(), display = displaySeconds_.median();
    if (lastMeasured_ == 0)
        return 1;
    const std::uint32_t n = iterationsPerFrame(pace.efficiency, pace.framesPerSecond, iteration, display);
    return std::min(n, kGrowth * lastMeasured_);
}

double FrameTimer::efficiency() const {
    return std::min(iterationSeconds_.median() * rates_.median(), 1.0);
}

}  // namespace pdr
