#include "app/presenters/image_cost.h"

#include <cmath>

#include "render/accuracy/quality.h"

namespace pdr::app {
namespace {

/// Returns a key shared by images that take about as long per pixel: device and look.
QString kindOf(const Frame& frame) {
    return QString::fromStdString(frame.device + "/" + frame.lookName);
}

double pixelsOf(ivec2 size) {
    return double(size.x) * size.y;
}

}  // namespace

void keepPlanningTime(Settings& settings, const Frame& frame) {
    for (const QualityStep& step : frame.steps)
        if (step.levels == kPlanningLevels && !step.atLeast())
            settings.keepPlanningSeconds(kindOf(frame), step.seconds.value / pixelsOf(frame.size));
}

std::optional<double> lastPlanningTime(const Settings& settings, const Frame& frame, ivec2 film) {
    const std::optional<double> perPixel = settings.planningSeconds(kindOf(frame));
    return perPixel ? std::optional(*perPixel * pixelsOf(film)) : std::nullopt;
}

std::optional<ui::ImageCost> costOf(const Settings& settings, const Frame& frame) {
    const double error = frame.status.displayError;
    if (!frame.coarse && std::isfinite(error) && error > 0 && frame.seconds > 0)
        return ui::ImageCost{frame.seconds * error * error / pixelsOf(frame.size)};
    if (const std::optional<double> last = settings.planningSeconds(kindOf(frame)))
        return ui::ImageCost{*last * kPlanningLevels * kPlanningLevels};
    return std::nullopt;
}

}  // namespace pdr::app
