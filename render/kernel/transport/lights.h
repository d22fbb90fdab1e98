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
template <class Real>
struct LightSampleOf {
    Vec3<Real> wi;  ///< unit, local
    Real distance;  ///< mm
    Vec3<Real> radiance;
    Real pdf;  ///< pdf of `wi`; 0: no other technique finds this light
};
using LightSample = LightSampleOf<float>;

/// The point where a ray meets a light, and the pdf with which sampleLight would have chosen that direction.
template <class Real>
struct LightHitOf {
    typename SimdTraits<Real>::Mask met;
    Real distance;  ///< mm; negative: behind the ray's origin
    Real pdf;
};
using LightHit = LightHitOf<float>;

template <class Real>
PDR_HD inline LightSampleOf<Real> dark() {
    return {{Real{}, Real{}, Real{} + 1.0f}, Real{}, Vec3<Real>{}, Real{}};
}
/// Returns `light` where `lit` holds.
template <class Real>
PDR_HD_INLINE LightSampleOf<Real> where(typename SimdTraits<Real>::Mask lit, const LightSampleOf<Real>& light) {
    const LightSampleOf<Real> none = dark<Real>();
    return {chosen(lit, light.wi, none.wi), lit ? light.distance : none.distance,
            chosen(lit, light.radiance, none.radiance), lit ? light.pdf : none.pdf};
}

// ---- rectangle

/// Samples a point of the rectangle, uniformly over its area. `from`: the lit position, relative to the centre.
template <class Real>
PDR_HD inline LightSampleOf<Real> sampleRectangle(const FlatLight& light, const Vec3<Real>& from, const Vec2<Real>& u) {
    using Mask = typename SimdTraits<Real>::Mask;
    const Vec3<Real> path = light.halfU * (2.0f * u.x - 1.0f) + light.halfV * (2.0f * u.y - 1.0f) - from;
    const Real squared = dot(path, path);
    const Real distance = squareRoot(squared);
    const Real facing = -dot(light.normal, path);
    const Mask lit = facing > 0.0f;
    if (!any(lit))
        return dark<Real>();
    const Real solidAngle = light.area * facing / (distance * squared);
    return where<Real>(lit, {path / distance, distance, light.radiance * solidAngle, 1.0f / solidAngle});
}

template <class Real>
PDR_HD inline LightHitOf<Real> intersectRectangle(const FlatLight& light, const Vec3<Real>& from,
                                                  const Vec3<Real>& direction) {
    using Mask = typename SimdTraits<Real>::Mask;
    const Real facing = -dot(light.normal, direction);
    const Mask faced = facing > 0.0f;
    if (!any(faced))
        return LightHitOf<Real>{};
    const Real distance = dot(light.normal, from) / facing;
    const Vec3<Real> place = from + direction * distance;
    const Mask beside = (magnitude(dot(place, light.halfU)) > glm::dot(light.halfU, light.halfU)) |
                        (magnitude(dot(place, light.halfV)) > glm::dot(light.halfV, light.halfV));
    return {Mask(faced & !beside), distance, distance * distance / (light.area * facing)};
}

// ---- sphere

/// Returns 1 - cosine of the half angle that the sphere subtends; no cancellation for small or distant spheres.
template <class Real>
PDR_HD inline Real sphereOneMinusCosine(float radius, Real distanceSquared) {
    const Real sineSquared = radius * radius / distanceSquared;
    return sineSquared / (1.0f + squareRoot(1.0f - sineSquared));
}

/// Samples a direction in the cone that the sphere subtends, uniformly over its solid angle. A sphere does not light
/// its inside.
template <class Real>
PDR_HD inline LightSampleOf<Real> sampleSphere(const FlatLight& light, const Vec3<Real>& from, const Vec2<Real>& u) {
    using Mask = typename SimdTraits<Real>::Mask;
    const float radius = light.radius;
    const Real squared = dot(from, from);
    const Mask outside = squared > radius * radius;
    if (!any(outside))
        return dark<Real>();
    const Real cone = sphereOneMinusCosine(radius, squared);
    const Real oneMinusCosine = u.x * cone;
    const Real sineSquared = oneMinusCosine * (2.0f - oneMinusCosine), cosine = 1.0f - oneMinusCosine;
    const Real distance = squareRoot(squared);
    const Vec3<Real> axis = -from / distance;
    Vec3<Real> s, t;
    orthonormalBasis(axis, s, t);
    const Vec3<Real> wi = axis * cosine + circlePoint(s, t, u.y) * squareRoot(sineSquared);
    const Real inside = squareRoot(max(Real{}, radius * radius - squared * sineSquared));
    const Real solidAngle = 2 * kPi * cone;
    return where<Real>(outside, {wi, distance * cosine - inside, light.radiance * solidAngle, 1.0f / solidAngle});
}

template <class Real>
PDR_HD inline LightHitOf<Real> intersectSphere(const FlatLight& light, const Vec3<Real>& from,
                                               const Vec3<Real>& direction) {
    using Mask = typename SimdTraits<Real>::Mask;
    const float radius = light.radius;
    const Real squared = dot(from, from);
    const Real closest = -dot(from, direction);
    const Vec3<Real> aside = from + direction * closest;
    const Real inside = radius * radius - dot(aside, aside);
    const Mask met = (squared > radius * radius) & (inside > 0.0f);
    if (!any(met))
        return LightHitOf<Real>{};
    return {met, closest - squareRoot(inside), 1.0f / (2 * kPi * sphereOneMinusCosine(radius, squared))};
}

// ---- any light

/// Samples any light. `place`: the lit position, local [mm].
template <std::uint32_t F, class Real>
PDR_HD inline LightSampleOf<Real> sampleLight(const FlatLight& light, const Vec3<Real>& place, const Vec2<Real>& u) {
    if (has(F, kPlacedLights) && light.type == LightType::rectangle)
        return sampleRectangle<Real>(light, place - light.position, u);
    if (has(F, kPlacedLights) && light.type == LightType::sphere)
        return sampleSphere<Real>(light, place - light.position, u);
    return {everywhere<Real>(light.normal), Real{} + kFarAway, everywhere<Real>(light.radiance), Real{}};
}

/// Intersects any light. `from`: the ray's origin, relative to the light's position; `direction`: unit; both local.
template <class Real>
PDR_HD inline LightHitOf<Real> intersectLight(const FlatLight& light, const Vec3<Real>& from,
                                              const Vec3<Real>& direction) {
    if (light.type == LightType::rectangle)
        return intersectRectangle(light, from, direction);
    return light.type == LightType::sphere ? intersectSphere(light, from, direction) : LightHitOf<Real>{};
}

}  // namespace pdr
