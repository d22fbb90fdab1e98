#pragma once
/// Lights with a position and directional lights. sampleLight() samples a light as seen from a point, and
/// intersectLight() intersects a light with a ray. Pdfs are per solid angle [1/sr].

#include "render/kernel/features.h"
#include "render/kernel/flat_scene.h"
#include "render/kernel/random.h"
#include "render/kernel/transport/phase.h"

namespace pdr {

inline constexpr float kFarAway = 1e30f;

/// A sampled direction to a light. `radiance` is already divided by the pdf of the sample; 0: the light does not shine
/// there.
struct LightSample {
    vec3 wi;         ///< unit, local
    float distance;  ///< mm
    vec3 radiance;
    float pdf;  ///< pdf of `wi`; 0: no other technique finds this light
};

/// The point where a ray meets a light, and the pdf with which sampleLight would have chosen that direction.
struct LightHit {
    bool met;
    float distance;  ///< mm; negative: behind the ray's origin
    float pdf;
};

inline constexpr LightHit kNoLight{false, 0, 0};
PDR_HD inline LightSample dark() {
    return {vec3(0, 0, 1), 0, vec3(0), 0};
}

// ---- rectangle

/// Samples a point of the rectangle, uniformly over its area. `from`: the lit position, relative to the centre.
PDR_HD inline LightSample sampleRectangle(const FlatLight& light, vec3 from, vec2 u) {
    const vec3 path = light.halfU * (2 * u.x - 1) + light.halfV * (2 * u.y - 1) - from;
    const float squared = glm::dot(path, path);
    const float distance = std::sqrt(squared);
    const float facing = -glm::dot(light.normal, path);
    if (!(facing > 0))
        return dark();
    const float solidAngle = light.area * facing / (distance * squared);
    return {path / distance, distance, light.radiance * solidAngle, 1 / solidAngle};
}

PDR_HD inline LightHit intersectRectangle(const FlatLight& light, vec3 from, vec3 direction) {
    const float facing = -glm::dot(light.normal, direction);
    if (!(facing > 0))
        return kNoLight;
    const float distance = glm::dot(light.normal, from) / facing;
    const vec3 place = from + direction * distance;
    if (std::fabs(glm::dot(place, light.halfU)) > glm::dot(light.halfU, light.halfU) ||
        std::fabs(glm::dot(place, light.halfV)) > glm::dot(light.halfV, light.halfV))
        return kNoLight;
    return {true, distance, distance * distance / (light.area * facing)};
}

// ---- sphere

/// Returns 1 - cosine of the half angle that the sphere subtends; no cancellation for small or distant spheres.
PDR_HD inline float sphereOneMinusCosine(float radius, float distanceSquared) {
    const float sineSquared = radius * radius / distanceSquared;
    return sineSquared / (1 + std::sqrt(1 - sineSquared));
}

/// Samples a direction in the cone that the sphere subtends, uniformly over its solid angle. A sphere does not light
/// its inside.
PDR_HD inline LightSample sampleSphere(const FlatLight& light, vec3 from, vec2 u) {
    const float squared = glm::dot(from, from), radius = light.radius;
    if (!(squared > radius * radius))
        return dark();
    const float cone = sphereOneMinusCosine(radius, squared);
    const float oneMinusCosine = u.x * cone;
    const float sineSquared = oneMinusCosine * (2 - oneMinusCosine), cosine = 1 - oneMinusCosine;
    const float distance = std::sqrt(squared);
    const vec3 axis = -from / distance;
    vec3 s, t;
    orthonormalBasis(axis, s, t);
    const vec3 wi = axis * cosine + circlePoint(s, t, u.y) * std::sqrt(sineSquared);
    const float inside = std::sqrt(glm::max(radius * radius - squared * sineSquared, 0.0f));
    const float solidAngle = 2 * kPi * cone;
    return {wi, distance * cosine - inside, light.radiance * solidAngle, 1 / solidAngle};
}

PDR_HD inline LightHit intersectSphere(const FlatLight& light, vec3 from, vec3 direction) {
    const float squared = glm::dot(from, from), radius = light.radius;
    const float closest = -glm::dot(from, direction);
    const vec3 aside = from + direction * closest;
    const float inside = radius * radius - glm::dot(aside, aside);
    if (!(squared > radius * radius) || !(inside > 0))
        return kNoLight;
    return {true, closest - std::sqrt(inside), 1 / (2 * kPi * sphereOneMinusCosine(radius, squared))};
}

// ---- any light

/// Samples any light. `place`: the lit position, local [mm].
template <std::uint32_t F>
PDR_HD inline LightSample sampleLight(const FlatLight& light, vec3 place, vec2 u) {
    if (has(F, kPlacedLights) && light.type == LightType::rectangle)
        return sampleRectangle(light, place - light.position, u);
    if (has(F, kPlacedLights) && light.type == LightType::sphere)
        return sampleSphere(light, place - light.position, u);
    return {light.normal, kFarAway, light.radiance, 0};
}

/// Intersects any light. `from`: the ray's origin, relative to the light's position; `direction`: unit; both local.
PDR_HD inline LightHit intersectLight(const FlatLight& light, vec3 from, vec3 direction) {
    if (light.type == LightType::rectangle)
        return intersectRectangle(light, from, direction);
    return light.type == LightType::sphere ? intersectSphere(light, from, direction) : kNoLight;
}

}  // namespace pdr
