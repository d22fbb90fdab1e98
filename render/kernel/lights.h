#pragma once
/// Where light comes from: one verb, a sample of a light as seen from a point.

#include "render/kernel/features.h"
#include "render/kernel/flat_scene.h"
#include "render/kernel/random.h"

namespace pdr {

/// radiance is already divided by the density of the sample; 0: the light does not shine there.
struct LightSample {
    vec3 towards;    ///< unit, local
    float distance;  ///< mm
    vec3 radiance;
};

inline constexpr float kFarAway = 1e30f;

/// A point of the panel, uniform over its area.
PDR_HD inline LightSample samplePanel(const FlatLight& light, vec3 from, vec2 u) {
    const vec3 point = light.position + light.halfU * (2 * u.x - 1) + light.halfV * (2 * u.y - 1);
    const vec3 path = point - from;
    const float squared = glm::dot(path, path);
    const float distance = std::sqrt(squared);
    const float facing = -glm::dot(light.normal, path);
    if (!(facing > 0))
        return {vec3(0, 0, 1), 0, vec3(0)};
    return {path / distance, distance, light.radiance * (light.area * facing / (distance * squared))};
}

template <std::uint32_t F>
PDR_HD inline LightSample sampleLight(const FlatLight& light, vec3 from, vec2 u) {
    if (has(F, kPlacedLights) && light.type == LightType::rectangle)
        return samplePanel(light, from, u);
    return {light.normal, kFarAway, light.radiance};
}

}  // namespace pdr
