#include "render/measure/distance.h"

#include <algorithm>
#include <cmath>

#include "render/measure/line.h"

namespace pdr::measure {
namespace {

/// Smallest distance that is an estimate, in spreads across the line.
constexpr double kNearestSpreads = 3;

bool isThin(const VolumeGeometry& geometry, const Line& line, const Place& a, const Place& b) {
    return isAtEdge(a) && isAtEdge(b) &&
           (a.thin || b.thin || line.lengthMm < resolvedMm(geometry, line.direction, std::max(a.blurMm, b.blurMm)));
}

}  // namespace

Stated distance(const VolumeGeometry& geometry, const Place& a, const Place& b) {
    const Line line(a, b);
    const std::array<Place, 2> places{a, b};
    const std::array<dvec3, 2> gradients{-line.direction, line.direction};
    const double value = line.lengthMm > 0 ? line.lengthMm - line.lengtheningMm() : 0;
    const Stated stated = propagated(value, places, gradients, 0, INFINITY);
    const double more = kSigmas95 * std::sqrt(largestVariance(line.spread));
    // Whatever is thinner than the blur of its edges looks as wide as that.
    if (isThin(geometry, line, a, b))
        return asAtMost(stated, std::max({line.lengthMm, a.blurMm, b.blurMm}) + more, Limit::thin);
    if (line.lengthMm < kNearestSpreads * std::sqrt(line.varianceAcross()))
        return asAtMost(stated, line.lengthMm + more, Limit::spread);
    return stated;
}

}  // namespace pdr::measure
