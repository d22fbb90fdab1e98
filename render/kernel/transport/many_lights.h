#pragma once
/// Selection of the lights that an event samples and that a ray may meet. Up to kMostLightsInTurn lights, these are
/// all. Of more lights, an event samples some in proportion to what they bring to the volume, and those on a ray are
/// found in a tree of bounding spheres (prepare/light_tables.h).

#include <type_traits>

#include "render/kernel/flat_scene.h"
#include "render/kernel/intervals.h"
#include "render/kernel/sampler.h"

namespace pdr {

inline constexpr int kMostLightsInTurn = 32;
/// Number of lights that an event samples if there are more than kMostLightsInTurn.
inline constexpr int kLightsPicked = 16;

/// Calls visit(light, weight) for the lights that an event samples. On average over the picks each light's weights add
/// up to 1. The picks are at equal distances in the table (systematic sampling), so that a light is picked as often as
/// expected, to within less than one pick. An environment image is sampled by the same number: the contributions of
/// both are added, so their sum is right even though they are correlated.
template <class Visit>
PDR_HD inline void forLightsLookedAt(const FlatScene& scene, const Sampler& sampler, int bounce, Visit&& visit) {
    if (scene.lightSums == nullptr) {
        for (int i = 0; i < scene.lightCount; ++i)
            visit(scene.lights[i], 1.0f);
        return;
    }
    const float u = sampler.number(bounce, BounceDimension::environment);
    const float whole = scene.lightSums[scene.lightCount];
    for (int pick = 0; pick < kLightsPicked; ++pick) {
        const int i = intervalOf(scene.lightSums, scene.lightCount, (float(pick) + u) / kLightsPicked);
        const float share = scene.lightSums[i + 1] - scene.lightSums[i];
        visit(scene.lights[i], whole / (kLightsPicked * share));
    }
}

PDR_HD inline bool passesThrough(const FlatLightNode& node, vec3 place, vec3 direction) {
    const vec3 to = node.centre - place;
    const float along = glm::dot(to, direction);
    const vec3 aside = to - direction * along;
    return along > -node.radius && glm::dot(aside, aside) < node.radius * node.radius;
}

template <class Visit>
PDR_HD inline void forLightsInTree(const FlatScene& scene, vec3 place, vec3 direction, Visit&& visit) {
    for (int i = 0; i < scene.lightNodeCount;) {
        const FlatLightNode& node = scene.lightNodes[i];
        const bool passes = passesThrough(node, place, direction);
        if (passes && node.light >= 0)
            visit(scene.lights[node.light]);
        i = passes ? i + 1 : node.next;
    }
}

/// Calls visit(light) for each light that a ray may meet. `place`: the ray's origin, in the volume; `direction`: unit;
/// both local. For lanes, there must be few lights.
template <class Real, class Visit>
PDR_HD inline void forLightsOnRay(const FlatScene& scene, const Vec3<Real>& place, const Vec3<Real>& direction,
                                  Visit&& visit) {
    if (!std::is_same_v<Real, float> || scene.lightSums == nullptr)
        for (int i = 0; i < scene.lightCount; ++i)
            visit(scene.lights[i]);
    else if constexpr (std::is_same_v<Real, float>)
        forLightsInTree(scene, place, direction, visit);
}

}  // namespace pdr
