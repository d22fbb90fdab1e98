#include "app/document/background_colour.h"

#include "render/film/display/tone_map.h"

namespace pdr::app {
namespace {

/// Returns the least radiance [per channel] that is shown at `level` or above. Bisection works with every tone curve,
/// since levels grow with radiance.
double leastAt(int level, const Display& display) {
    double below = 0, above = 1e3 * double(display.exposure);
    for (int i = 0; i < 60; ++i) {
        const double middle = (below + above) / 2;
        (displayLevel(middle, display) < level ? below : above) = middle;
    }
    return above;
}

float radianceAt(int level, const Display& display) {
    if (level <= 0)
        return 0;
    const double least = leastAt(level, display);
    return float(level < 255 ? (least + leastAt(level + 1, display)) / 2 : least);
}

}  // namespace

QColor shownColour(vec3 radiance, const Display& display) {
    const auto level = [&](float channel) { return int(displayLevel(double(channel), display)); };
    return {level(radiance.x), level(radiance.y), level(radiance.z)};
}

vec3 radianceShownAs(const QColor& colour, const Display& display) {
    return {radianceAt(colour.red(), display), radianceAt(colour.green(), display), radianceAt(colour.blue(), display)};
}

}  // namespace pdr::app
