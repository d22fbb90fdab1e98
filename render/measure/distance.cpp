#include "render/measure/distance.h"

#include <algorithm>
#include <cmath>

#include "render/measure/line.h"

namespace pdr::measure {
namespace {

/// Smallest distance that is an estimate, in spreads across the line.
constexpr double kNearestSpreads = 3;

/// Longest line between both sides of one thin thing, in resolved distances: places of a click lie askew.
constexpr double kThroughOne = 2;

/// Returns whether the line may lead through a single thing that the scan blurs.
bool isThin(const VolumeGeometry& geometry, const Line& line, const Place& a, const Place& b) {
    const double resolved = resolvedMm(geometry, line.direction, std::max(a.blurMm, b.blurMm));
    const double thinnest = a.thin || b.thin ? kThroughOne * resolved : resolved;
    return isAtEdge(a) && isAtEdge(b) && line.lengthMm < thinnest;
}

/// Adds how far a thin wall at an end of a line may lie beside its half level: half of its blur.
void addThinWall(Stated& stated, const Place& end) {
    if (!end.thin)
        return;
    double& share = stated.shares[std::size_t(Cause::edge)];
    share = std::hypot(share, end.blurMm / 2);
    stated.low = std::max(0.0, stated.value - stated.plusMinus());
    stated.high = stated.value + stated.plusMinus();
}

}  // namespace

Stated distance(const VolumeGeometry& geometry, const Place& a, const Place& b) {
    const Line line(a, b);
    const std::array<Place, 2> places{a, b};
    const std::array<dvec3, 2> gradients{-line.direction, line.direction};
    const double value = line.lengthMm > 0 ? line.lengthMm - line.lengtheningMm() : 0;
    Stated stated = propagated(value, places, gradients, 0, INFINITY);
    for (const Place& end : places)
        addThinWall(stated, end);
    const double more = kSigmas95 * std::sqrt(largestVariance(line.spread));
    // Whatever is thinner than the blur of its edges looks as wide as that.
    if (isThin(geometry, line, a, b))
        return asAtMost(stated, std::max({line.lengthMm, a.blurMm, b.blurMm}) + more, Limit::thin);
    if (line.lengthMm < kNearestSpreads * std::sqrt(line.varianceAcross()))
        return asAtMost(stated, line.lengthMm + more, Limit::spread);
    return stated;
}

}  // namespace pdr::measure
