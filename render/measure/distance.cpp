#include "render/measure/distance.h"

#include <algorithm>
#include <cmath>

#include "render/measure/line.h"

namespace pdr::measure {
namespace {

/// Smallest distance of two edges that a scan can tell, in mm, steps of its grid and widths of its edges. Two edges
/// with Gaussian blur of sigma s reach 96 % of their step between them when they are 4.2 s apart, which is 1.7 widths.
constexpr double kThinnestMm = 2.5, kThinnestSteps = 2.5, kThinnestWidths = 1.7;

/// Smallest distance that is an estimate, in spreads across the line.
constexpr double kNearestSpreads = 3;

}  // namespace

double thinnestMm(const VolumeGeometry& geometry, const Place& a, const Place& b) {
    if (!isAtEdge(a) || !isAtEdge(b) || a.mm == b.mm)
        return 0;
    const double step = stepAlongMm(geometry, glm::normalize(b.mm - a.mm));
    return std::max({kThinnestMm, kThinnestSteps * step, kThinnestWidths * std::max(a.blurMm, b.blurMm)});
}

Stated distance(const VolumeGeometry& geometry, const Place& a, const Place& b) {
    const Line line(a, b);
    const std::array<Place, 2> places{a, b};
    const std::array<dvec3, 2> gradients{-line.direction, line.direction};
    const double value = line.lengthMm > 0 ? line.lengthMm - line.lengtheningMm() : 0;
    const Stated stated = propagated(value, places, gradients, 0, INFINITY);
    const auto atMost = [&](Limit limit) {
        return asAtMost(stated, line.lengthMm + kSigmas95 * std::sqrt(largestVariance(line.spread)), limit);
    };
    if (line.lengthMm < kNearestSpreads * std::sqrt(line.varianceAcross()))
        return atMost(Limit::spread);
    return line.lengthMm < thinnestMm(geometry, a, b) ? atMost(Limit::thin) : stated;
}

}  // namespace pdr::measure
