#include "render/prepare/focus.h"

#include <algorithm>
#include <vector>

#include "render/kernel/pixel.h"
#include "render/kernel/transport/integrator.h"

namespace pdr {

namespace {

constexpr int kRays = 65;

}  // namespace

std::optional<double> depthUnder(const PreparedScene& scene, ivec2 pixel) {
    const FlatScene& flat = scene.flat;
    if (glm::any(glm::lessThan(pixel, ivec2(0))) || glm::any(glm::greaterThanEqual(pixel, flat.camera.film)))
        return std::nullopt;
    const PathSegment segment = generateCameraRay(flat, vec2(pixel) + 0.5f, vec2(0), vec2(0, 1e30f));
    const dvec3 start(localPosition(flat.volume, segment.ray.origin));
    std::vector<double> depths;
    for (int i = 0; i < kRays && segment.ray.length > 0; ++i) {
        const Random random(flat.seed, 0, std::uint64_t(i));
        const float t = track<DeltaTracking>(flat, segment.ray, random.stream(0, BounceDimension::distance));
        if (t >= 0)
            depths.push_back(
                glm::dot(start + dvec3(segment.direction) * double(t) - flat.camera.localEye, flat.camera.forward));
    }
    if (depths.size() <= kRays / 2)
        return std::nullopt;
    std::ranges::sort(depths);
    return depths[kRays / 2];
}

}  // namespace pdr
