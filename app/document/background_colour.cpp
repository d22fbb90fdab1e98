#include "app/document/background_colour.h"

#include <algorithm>

#include "render/film/display_transform.h"

namespace pdr::app {
namespace {

/// Returns the level of channel c, beside the others of `light`, if it has the radiance `channel`.
int levelWith(const DisplayTransform& transform, vec3 light, int c, double channel) {
    std::uint8_t levels[3];
    dvec3 shown(light);
    shown[c] = channel;
    transform.setLevels(shown, levels);
    return levels[c];
}

/// Returns the least radiance of channel c, up to `most`, that is shown at `level` or above. Bisection works with every
/// tone curve, since levels grow with radiance.
double leastAt(const DisplayTransform& transform, vec3 light, int c, int level, double most) {
    double below = 0, above = most;
    for (int i = 0; i < 60; ++i) {
        const double middle = (below + above) / 2;
        (levelWith(transform, light, c, middle) < level ? below : above) = middle;
    }
    return above;
}

float radianceAt(const DisplayTransform& transform, vec3 light, int c, int level, double most) {
    if (level <= levelWith(transform, light, c, 0))
        return 0;
    const double least = leastAt(transform, light, c, level, most);
    return float(level < 255 ? (least + leastAt(transform, light, c, level + 1, most)) / 2 : least);
}

}  // namespace

QColor shownColour(vec3 radiance, const Display& display) {
    std::uint8_t levels[3];
    displayTransform(display).setLevels(dvec3(radiance), levels);
    return {levels[0], levels[1], levels[2]};
}

vec3 radianceShownAs(const QColor& colour, const Display& display) {
    const DisplayTransform transform = displayTransform(display);
    const int levels[3] = {colour.red(), colour.green(), colour.blue()};
    const int most = std::max({levels[0], levels[1], levels[2]});
    // The largest channels go first, since the others depend on them
    vec3 radiance(0.0f);
    for (int c = 0; c < 3; ++c)
        if (levels[c] == most)
            radiance[c] = radianceAt(transform, vec3(0), c, most, 1e3 * transform.exposure);
    const float largest = std::max({radiance.x, radiance.y, radiance.z});
    for (int c = 0; c < 3; ++c)
        if (levels[c] < most)
            radiance[c] = radianceAt(transform, radiance, c, levels[c], double(largest));
    return radiance;
}

}  // namespace pdr::app
