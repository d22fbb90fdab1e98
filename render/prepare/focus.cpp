#include "render/prepare/focus.h"

#include <algorithm>
#include <cmath>

#include "render/kernel/transport/camera_ray.h"
#include "render/kernel/transport/free_flight.h"
#include "render/kernel/volume_sampling.h"

namespace pdr {

namespace {

/// A ray, and the distance along it at which half of its light has met an event [mm].
struct Hit {
    PathSegment segment;
    float distance;
};

std::optional<Hit> hitUnder(const FlatScene& scene, ivec2 pixel) {
    if (glm::any(glm::lessThan(pixel, ivec2(0))) || glm::any(glm::greaterThanEqual(pixel, scene.camera.film)))
        return std::nullopt;
    const PathSegment segment = generateCameraRay(scene, vec2(pixel) + 0.5f, vec2(0), vec2(0, 1e30f));
    const float distance = freeFlight(scene, segment.ray, -std::log(0.5f)).distance;
    return distance < 0 ? std::nullopt : std::optional(Hit{segment, distance});
}

}  // namespace

std::optional<double> depthUnder(const PreparedScene& scene, ivec2 pixel) {
    const FlatScene& flat = scene.flat;
    const std::optional<Hit> hit = hitUnder(flat, pixel);
    if (!hit)
        return std::nullopt;
    const dvec3 start(localPosition(flat.volume, hit->segment.ray.origin));
    const dvec3 place = start + dvec3(hit->segment.direction) * double(hit->distance);
    return glm::dot(place - flat.camera.localEye, flat.camera.forward);
}

std::optional<TissueUnder> tissueUnder(const PreparedScene& scene, ivec2 pixel) {
    constexpr int kPlaces = 16;
    constexpr float kThickMm = 2;
    const std::optional<Hit> hit = hitUnder(scene.flat, pixel);
    if (!hit)
        return std::nullopt;
    const Ray& ray = hit->segment.ray;
    const float thick = std::min(kThickMm, ray.length - hit->distance);
    double sum = 0, squares = 0;
    for (int i = 0; i < kPlaces; ++i) {
        const float along = hit->distance + thick * (float(i) + 0.5f) / kPlaces;
        const auto hu = double(interpolatedHounsfield(scene.flat.volume, ray.origin + ray.direction * along));
        sum += hu;
        squares += hu * hu;
    }
    const double mean = sum / kPlaces;
    return TissueUnder{float(mean), float(std::sqrt(std::max(squares / kPlaces - mean * mean, 0.0)))};
}

}  // namespace pdr
