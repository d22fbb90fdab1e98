#include "render/scene/edit/curve_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pdr {
namespace {

float within(float hu) {
    return std::clamp(hu, kLowestHu, kHighestHu);
}

}  // namespace

Curve windowCurve(float level, float width, float top) {
    return {{within(level - width / 2), 0}, {within(level + width / 2), top}};
}

Curve thresholdCurve(float hu, float top) {
    return windowCurve(hu, 0, top);
}

Curve bellCurve(float centre, float width, float top) {
    constexpr int kPieces = 8;
    Curve bell;
    for (int i = 0; i <= kPieces; ++i) {
        const double place = 2.0 * i / kPieces - 1;  // in half bases, each as wide as the bell at half its height
        const double height = 0.5 * (1 + std::cos(place * std::numbers::pi));
        bell.push_back({within(float(centre + place * width)), i % kPieces == 0 ? 0 : float(top * height)});
    }
    return bell;
}

}  // namespace pdr
