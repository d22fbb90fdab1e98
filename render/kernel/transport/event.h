#pragma once
/// A collision in the medium: where it is and how it sends light on, by a surface or by the phase function.

#include "render/kernel/attenuation.h"
#include "render/kernel/clip.h"
#include "render/kernel/features.h"
#include "render/kernel/gradient.h"
#include "render/kernel/medium.h"
#include "render/kernel/transport/phase.h"
#include "render/kernel/transport/surface.h"

namespace pdr {

struct Event {
    vec3 position;  ///< index space
    vec3 wo;        ///< unit, local: to where the path came from
    Material material;
    vec3 normal;  ///< local, unit, on the side that the path came from; zero: the phase function holds
};

/// FlatScene::surfaceFactor [mm/HU] of a gradient factor: 25 gradientFactor^3 / range. The range is that of 12-bit CT
/// and not the volume's own, so that one metal clip does not change how the rest of the picture looks.
PDR_HD inline float surfaceFactorOf(float gradientFactor) {
    constexpr float kHuScale = 4096;
    return 25 * gradientFactor * gradientFactor * gradientFactor / kHuScale;
}

/// A surface is the more likely the denser and the steeper the tissue: P = opacity (1 - exp(-surfaceFactor |grad|)),
/// Kroes, Post & Botha 2012.
PDR_HD inline float surfaceProbability(const FlatScene& scene, float opacity, float steepness) {
    return opacity * attenuation(scene.surfaceFactor * steepness).taken;
}

/// What is cut away or hidden is as air is.
inline constexpr float kHiddenHu = -1000;

/// The gradient of tissue of `hu` as it is seen [HU/mm]: what a mask hides counts as air, so that it has a surface
/// where it does not end, but is hidden.
PDR_HD inline vec3 seenGradient(const FlatScene& scene, vec3 position, float hu) {
    const vec3 gradient = hounsfieldGradient(scene.volume, position);
    const float weight = isMasked(scene) ? weightAt(scene, position) : 1;
    if (!(weight < 1))
        return gradient;
    return weight * gradient + glm::max(hu - kHiddenHu, 0.0f) * weightGradient(scene, position);
}

PDR_HD inline vec3 facing(vec3 wo, vec3 normal) {
    return glm::dot(normal, wo) < 0 ? -normal : normal;
}

/// No gradient, no surface. Its probability is never above the opacity, so the
/// gradient, which costs 64 voxels, is looked at only where the number lies below that.
PDR_HD inline vec3 surfaceNormal(const FlatScene& scene, vec3 position, vec3 wo, float hu, float u) {
    const float most = opacity(scene.transferFunction, hu);
    if (u >= most)
        return vec3(0);
    const vec3 gradient = seenGradient(scene, position, hu);
    const float steepness = glm::length(gradient);
    if (!(steepness > 0))
        return vec3(0);
    if (u >= surfaceProbability(scene, most, steepness))
        return vec3(0);
    return facing(wo, gradient / steepness);
}

/// The step from tissue of `hu` to air, across one voxel [HU/mm].
PDR_HD inline float cutSteepness(float hu, float voxelMm) {
    return glm::max(hu - kHiddenHu, 0.0f) / voxelMm;
}

/// Tissue that a plane cuts through ends at that plane: it reflects with the plane's normal, as an edge against air
/// does that is one voxel wide. The gradient of the HU knows nothing of the cut; within tissue it is that of the noise.
PDR_HD inline vec3 cutFaceNormal(const FlatScene& scene, const CutFace& face, vec3 wo, float hu, float u) {
    const float steepness = cutSteepness(hu, face.voxelMm);
    if (u >= surfaceProbability(scene, opacity(scene.transferFunction, hu), steepness))
        return vec3(0);
    return facing(wo, glm::normalize(glm::transpose(scene.volume.indexFromLocal) * face.normal));
}

/// The normal of the surface at an event; zero: none.
PDR_HD inline vec3 normalAt(const FlatScene& scene, vec3 position, vec3 wo, float hu, float u) {
    const CutFace face = cutFaceNear(scene.clip, position);
    if (face.voxelMm > 0 && opacity(scene.transferFunction, hounsfield(scene.volume, face.foot)) > 0)
        return cutFaceNormal(scene, face, wo, hu, u);
    return surfaceNormal(scene, position, wo, hu, u);
}

/// `u` decides whether the event is at a surface.
template <std::uint32_t F>
PDR_HD_INLINE Event eventAt(const FlatScene& scene, vec3 position, vec3 wo, float u) {
    const float hu = hounsfield(scene.volume, position);
    Event event{position, wo, materialAt(scene.transferFunction, hu), vec3(0)};
    if constexpr (has(F, kSurface))
        event.normal = normalAt(scene, position, wo, hu, u);
    return event;
}

template <std::uint32_t F>
PDR_HD inline bool isSurface(const Event& event) {
    return has(F, kSurface) && event.normal != vec3(0);
}

/// Light scattered back along the path per radiance from direction `wi` (unit, local) [1/sr].
template <std::uint32_t F>
PDR_HD inline vec3 scatterEval(const FlatScene& scene, const Event& event, vec3 wi) {
    if (isSurface<F>(event))
        return surfaceEval(event.material, event.normal, event.wo, wi);
    return event.material.albedo * phaseEval(scene.phaseG, event.wo, wi);
}

/// The pdf with which scatterSample finds `wi` [1/sr].
template <std::uint32_t F>
PDR_HD inline float scatterPdf(const FlatScene& scene, const Event& event, vec3 wi) {
    if (isSurface<F>(event))
        return surfacePdf(event.material, event.normal, event.wo, wi);
    return phaseEval(scene.phaseG, event.wo, wi);
}

/// A direction and the light scattered back per radiance from there, already divided by the direction's pdf.
struct Scattered {
    vec3 wi;
    vec3 weight;
};

template <std::uint32_t F>
PDR_HD inline Scattered scatterSample(const FlatScene& scene, const Event& event, vec3 u) {
    if (!isSurface<F>(event))
        return {phaseSample(scene.phaseG, event.wo, vec2(u)), event.material.albedo};
    const vec3 wi = surfaceSample(event.material, event.normal, event.wo, u.z, vec2(u));
    const float pdf = surfacePdf(event.material, event.normal, event.wo, wi);
    if (!(pdf > 0))
        return {wi, vec3(0)};
    return {wi, surfaceEval(event.material, event.normal, event.wo, wi) / pdf};
}

}  // namespace pdr
