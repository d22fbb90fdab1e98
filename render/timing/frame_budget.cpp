#include "render/timing/frame_budget.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/timing/iterations.h"

namespace pdr {

namespace {

constexpr std::size_t kRecentFrames = 9;
/// From a measured frame to the next: of few iterations little is learned.
constexpr std::uint32_t kGrowth = 4;

}  // namespace

FrameBudget FrameBudget::clamped() const {
    return {automatic, int(allowedIterations(iterations)), std::clamp(framesPerSecond, 0.1, 60.0),
            std::clamp(efficiency, 0.01, 0.9999)};
}

void FrameTimer::addFrame(std::uint32_t n, double iterationSeconds, double displaySeconds) {
    keep(iterationSeconds_, iterationSeconds / n);
    keep(displaySeconds_, displaySeconds);
    lastMeasured_ = n;
    addPeriod(n, iterationSeconds + displaySeconds);
}

void FrameTimer::addPeriod(std::uint32_t n, double seconds) {
    if (seconds > 0)
        keep(rates_, n / seconds);
}

bool FrameTimer::settled() const {
    return displaySeconds_.size() == kRecentFrames;
}

std::uint32_t FrameTimer::iterations(const FrameBudget& pace) const {
    if (!pace.automatic)
        return std::uint32_t(pace.iterations);
    const double iteration = median(iterationSeconds_), display = median(displaySeconds_);
    if (lastMeasured_ == 0)
        return 1;
    const std::uint32_t n = iterationsPerFrame(pace.efficiency, pace.framesPerSecond, iteration, display);
    return std::min(n, kGrowth * lastMeasured_);
}

double FrameTimer::efficiency() const {
    return std::min(median(iterationSeconds_) * median(rates_), 1.0);
}

void FrameTimer::keep(Recent& recent, double value) {
    recent.push_back(value);
    if (recent.size() > kRecentFrames)
        recent.pop_front();
}

double FrameTimer::median(const Recent& recent) {
    if (recent.empty())
        return 0;
    std::vector<double> sorted(recent.begin(), recent.end());
    const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

}  // namespace pdr
