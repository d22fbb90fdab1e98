#include "render/prepare/focus.h"

#include <cmath>

#include "render/kernel/transport/camera_ray.h"
#include "render/kernel/transport/free_flight.h"
#include "render/kernel/volume_sampling.h"

namespace pdr {

std::optional<double> depthUnder(const PreparedScene& scene, ivec2 pixel) {
    const FlatScene& flat = scene.flat;
    if (glm::any(glm::lessThan(pixel, ivec2(0))) || glm::any(glm::greaterThanEqual(pixel, flat.camera.film)))
        return std::nullopt;
    const PathSegment segment = generateCameraRay(flat, vec2(pixel) + 0.5f, vec2(0), vec2(0, 1e30f));
    const float t = freeFlight(flat, segment.ray, -std::log(0.5f)).distance;
    if (t < 0)
        return std::nullopt;
    const dvec3 start(localPosition(flat.volume, segment.ray.origin));
    return glm::dot(start + dvec3(segment.direction) * double(t) - flat.camera.localEye, flat.camera.forward);
}

}  // namespace pdr
