#include "render/prepare/first_events.h"

#include <algorithm>
#include <cmath>

#include "render/kernel/transport/free_flight.h"

namespace pdr {

namespace {

/// Returns the share of the light that meets tissue on the whole of `ray`.
double metOn(const FlatScene& scene, const Ray& ray) {
    if (!(ray.length > 0))
        return 0;
    const Flight flight = freeFlight(scene, ray, kOpaqueDepth);
    return flight.distance < 0 ? -std::expm1(-double(flight.passed)) : 1;
}

}  // namespace

FirstEvents::FirstEvents(const FlatScene& scene, vec2 place)
    : scene_(scene),
      segment_(generateCameraRay(scene, place, vec2(0), vec2(0, 1e30f))),
      met_(metOn(scene, segment_.ray)) {}

double FirstEvents::metBefore(double mm) const {
    Ray part = segment_.ray;
    part.length = std::min(part.length, float(mm));
    return metOn(scene_, part);
}

double FirstEvents::where(double share) const {
    const float distance = freeFlight(scene_, segment_.ray, float(-std::log1p(-share))).distance;
    return distance < 0 ? segment_.ray.length : distance;
}

/// Each flight starts where the one before it ended, so that all of them together pass the ray once.
std::vector<double> FirstEvents::quantiles(int count) const {
    std::vector<double> distances;
    Ray rest = segment_.ray;
    double passed = 0, along = 0;
    for (int i = 0; met_ > 0 && i < count; ++i) {
        const double depth = -std::log1p(-(i + 0.5) / count * met_);
        const float further = freeFlight(scene_, rest, float(depth - passed)).distance;
        along = further < 0 ? double(segment_.ray.length) : along + double(further);
        distances.push_back(along);
        passed = depth;
        rest.origin = segment_.ray.origin + segment_.ray.direction * float(along);
        rest.length = segment_.ray.length - float(along);
    }
    return distances;
}

}  // namespace pdr
