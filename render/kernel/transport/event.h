#pragma once
/// Events: a collision in the medium, its position, and how it scatters light, by a surface or by the phase function.

#include "render/kernel/attenuation.h"
#include "render/kernel/clip.h"
#include "render/kernel/features.h"
#include "render/kernel/transport/phase.h"
#include "render/kernel/transport/surface.h"
#include "render/kernel/transport/surface_gradient.h"

namespace pdr {

template <class Real>
struct EventOf {
    Vec3<Real> position;  ///< index space
    Vec3<Real> wo;        ///< unit, local: direction back along the path
    MaterialOf<Real> material;
    /// Normal of the surface: unit, local, on the side of wo; zero: the phase function scatters.
    Vec3<Real> normal;
};
using Event = EventOf<float>;

/// Returns the surfaceFactor of a curve [mm/HU] from its gradient factor: 25 gradientFactor^3 / range. The range is of
/// 12-bit CT and not the volume's own, so that one metal clip does not change how the rest of the image looks.
PDR_HD inline float surfaceFactorOf(float gradientFactor) {
    constexpr float kHuScale = 4096;
    return 25 * gradientFactor * gradientFactor * gradientFactor / kHuScale;
}

/// Returns the probability that an event is at a surface, which grows with the density and the gradient of the tissue:
/// P = opacity (1 - exp(-surfaceFactor |grad|)), Kroes, Post & Botha 2012.
PDR_HD inline float surfaceProbability(const FlatTransferFunction& curve, float opacity, float steepness) {
    return opacity * attenuation(glm::abs(curve.surfaceFactor) * steepness).taken;
}

PDR_HD inline vec3 facing(vec3 wo, vec3 normal) {
    return glm::dot(normal, wo) < 0 ? -normal : normal;
}

/// Returns the normal of a surface at `position`, in tissue of `curve`; zero if `u` chooses none or there is no
/// gradient. The probability of a surface is never above the opacity, so the gradient, which costs 64 voxels, is read
/// only where `u` is below the opacity.
PDR_HD inline vec3 surfaceNormal(const FlatScene& scene, const FlatTransferFunction& curve, vec3 position, vec3 wo,
                                 float hu, float u) {
    const float most = opacity(curve, hu);
    if (u >= most)
        return vec3(0);
    const vec3 gradient = surfaceGradient(scene, curve, position, hu);
    const float steepness = glm::length(gradient);
    if (!(steepness > 0))
        return vec3(0);
    if (u >= surfaceProbability(curve, most, steepness))
        return vec3(0);
    return facing(wo, gradient / steepness);
}

/// Returns the gradient of a step from tissue of `hu` to air, across one voxel [HU/mm].
PDR_HD inline float cutSteepness(float hu, float voxelMm) {
    return glm::max(hu - kHiddenHu, 0.0f) / voxelMm;
}

/// Returns the normal of a cut face; zero if `u` chooses no surface. Tissue that a plane cuts through ends at that
/// plane: it reflects with the plane's normal, like an edge against air that is one voxel wide. The gradient of the HU
/// does not know about the cut; inside tissue it is that of the noise.
PDR_HD inline vec3 cutFaceNormal(const FlatScene& scene, const FlatTransferFunction& curve, const CutFace& face,
                                 vec3 wo, float hu, float u) {
    const float steepness = cutSteepness(hu, face.voxelMm);
    if (u >= surfaceProbability(curve, opacity(curve, hu), steepness))
        return vec3(0);
    return facing(wo, glm::normalize(glm::transpose(scene.volume.indexFromLocal) * face.normal));
}

/// Returns the normal of the surface at an event; zero if there is none.
PDR_HD inline vec3 normalAt(const FlatScene& scene, const FlatTransferFunction& curve, vec3 position, vec3 wo, float hu,
                            float u) {
    const CutFace face = cutFaceNear(scene.clip, position);
    if (face.voxelMm > 0 && opacity(curve, hounsfield(scene.volume, face.foot)) > 0)
        return cutFaceNormal(scene, curve, face, wo, hu, u);
    return surfaceNormal(scene, curve, position, wo, hu, u);
}

/// Returns the event at `position`. `u` decides which tissue it is in, and whether it is at a surface.
template <std::uint32_t F>
PDR_HD_INLINE Event eventAt(const FlatScene& scene, vec3 position, vec3 wo, float u) {
    const float hu = hounsfield(scene.volume, position);
    const FlatTransferFunction curve = curveMet(scene, position, hu, u);
    Event event{position, wo, materialAt(curve, hu), vec3(0)};
    if constexpr (has(F, kSurface))
        event.normal = normalAt(scene, curve, position, wo, hu, u);
    return event;
}

template <std::uint32_t F, class Real>
PDR_HD inline auto isSurface(const EventOf<Real>& event) {
    using Mask = typename SimdTraits<Real>::Mask;
    if constexpr (has(F, kSurface))
        return Mask((event.normal.x != 0.0f) | (event.normal.y != 0.0f) | (event.normal.z != 0.0f));
    else
        return Mask{};
}

/// Returns the light scattered back along the path per radiance from direction `wi` (unit, local) [1/sr].
template <std::uint32_t F, class Real>
PDR_HD inline Vec3<Real> scatterEval(const FlatScene& scene, const EventOf<Real>& event, const Vec3<Real>& wi) {
    const auto surface = isSurface<F>(event);
    Vec3<Real> scattered{};
    if (any(surface))
        scattered = surfaceEval(event.material, event.normal, event.wo, wi);
    if (any(!surface))
        scattered = chosen(surface, scattered, event.material.albedo * phaseEval(scene.phaseG, event.wo, wi));
    return scattered;
}

/// Returns the pdf with which scatterSample finds `wi` [1/sr].
template <std::uint32_t F, class Real>
PDR_HD inline Real scatterPdf(const FlatScene& scene, const EventOf<Real>& event, const Vec3<Real>& wi) {
    const auto surface = isSurface<F>(event);
    Real pdf{};
    if (any(surface))
        pdf = surfacePdf(event.material, event.normal, event.wo, wi);
    if (any(!surface))
        pdf = surface ? pdf : phaseEval(scene.phaseG, event.wo, wi);
    return pdf;
}

/// A sampled direction, and the light scattered back per radiance from there, already divided by the direction's pdf.
template <class Real>
struct ScatteredOf {
    Vec3<Real> wi;
    Vec3<Real> weight;
};

template <std::uint32_t F, class Real>
PDR_HD inline ScatteredOf<Real> scatterSample(const FlatScene& scene, const EventOf<Real>& event, const Vec3<Real>& u) {
    const auto surface = isSurface<F>(event);
    ScatteredOf<Real> scattered{};
    if (any(surface)) {
        const Vec3<Real> wi = surfaceSample(event.material, event.normal, event.wo, u.z, Vec2<Real>(u.x, u.y));
        const Real pdf = surfacePdf(event.material, event.normal, event.wo, wi);
        const Vec3<Real> weight = surfaceEval(event.material, event.normal, event.wo, wi) / pdf;
        scattered = {wi, chosen(pdf > 0.0f, weight, Vec3<Real>{})};
    }
    if (any(!surface)) {
        const Vec3<Real> wi = phaseSample(scene.phaseG, event.wo, Vec2<Real>(u.x, u.y));
        scattered = {chosen(surface, scattered.wi, wi), chosen(surface, scattered.weight, event.material.albedo)};
    }
    return scattered;
}

}  // namespace pdr
