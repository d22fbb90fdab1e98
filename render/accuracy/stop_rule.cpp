#include "render/accuracy/stop_rule.h"

#include <algorithm>
#include <cmath>

namespace pdr {

double nearestTarget(double levels) {
    const double tenths = std::round(10 * levels);
    return std::clamp(tenths >= 30 ? std::round(levels) : tenths / 10, kFinestTarget, kCoarsestTarget);
}

std::optional<ForetoldStop> foretoldStop(const StopRule& rule, const std::vector<QualityStep>& steps,
                                         double secondsSpent, std::uint64_t samplesPerPixel) {
    const std::optional<Foretold> levels = secondsAt(steps, rule.levels);
    if (!levels || !(secondsSpent > 0) || samplesPerPixel == 0)
        return std::nullopt;
    using Cause = ForetoldStop::Cause;
    const double perSample = secondsSpent / double(samplesPerPixel);
    ForetoldStop stop{Cause::levels, std::max(levels->value, double(kSamplesToStop) * perSample)};
    if (rule.seconds < stop.seconds)
        stop = {Cause::seconds, rule.seconds};
    if (rule.samples > 0 && double(rule.samples) * perSample < stop.seconds)
        stop = {Cause::samples, double(rule.samples) * perSample};
    stop.samples = stop.cause == Cause::samples ? double(rule.samples) : stop.seconds / perSample;
    stop.levels = stop.cause == Cause::levels ? rule.levels : levelsAt(steps, stop.seconds);
    return stop;
}

}  // namespace pdr
