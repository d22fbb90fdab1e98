#pragma once
/// The optical models without scattering: from a ray to the radiance that the camera sees. There are no random numbers:
/// the same ray gives the same radiance.

#include "render/kernel/quadrature/ray_maximum.h"
#include "render/kernel/transport/integrator.h"

namespace pdr {

/// The walk along one ray of a model, or along several in lanes: start, going, step, take, result.
template <class Real, FlatModel Model, Tissue Kind>
struct RayWalkOf {
    using Type = RayIntegral<Real, Model, Kind>;
};
template <class Real, Tissue Kind>
struct RayWalkOf<Real, FlatModel::maximumIntensity, Kind> {
    using Type = RayMaximum<Real, Kind == Tissue::masked>;
};
template <class Real, FlatModel Model, Tissue Kind>
using RayWalk = typename RayWalkOf<Real, Model, Kind>::Type;

/// Returns call.operator()<Kind>() for the kind of tissue that a model sees: of these, absorption alone shows parts.
template <FlatModel Model, class Call>
PDR_HD_INLINE auto forProjectedTissue(const FlatScene& scene, Call&& call) {
    if constexpr (Model == FlatModel::absorption)
        return forTissue(scene, call);
    else
        return isMasked(scene) ? call.template operator()<Tissue::masked>() : call.template operator()<Tissue::whole>();
}

struct Projected {
    vec3 radiance;         ///< linear Rec. 709
    bool withinTolerance;  ///< the error bound is within FlatOptics::quadrature and cutOff
    bool tissue;           ///< the ray met visible tissue
};

/// Calls note(fault) for each fault, as noteFaults() of a PathSample does.
template <class Note>
PDR_HD inline void noteFaults(const Projected& found, Note&& note) {
    if (!found.withinTolerance)
        note(Fault::overTolerance);
}

/// Returns the radiance behind the volume. Absorption needs a light to absorb: white, if the camera sees no
/// environment.
template <FlatModel Model>
PDR_HD inline vec3 backdrop(const FlatScene& scene, const PathSegment& segment) {
    const FlatEnvironment& environment = scene.environment;
    if constexpr (Model == FlatModel::absorption)
        return !environment.visible || (environment.zenith == vec3(0) && environment.nadir == vec3(0))
                   ? vec3(1)
                   : environmentRadiance(environment, segment.direction);
    return background(scene, segment);
}

/// Returns the radiance that the tone map shows, at exposure 1, as a grey proportional to the HU within the window:
/// sRGB (IEC 61966-2-1) and 1 - exp(-L), inverted. White is kept half a display level below infinity.
PDR_HD inline float windowed(const FlatOptics& optics, float hu) {
    const float place = (hu - optics.windowLow) / (optics.windowHigh - optics.windowLow);
    const float grey = glm::clamp(place, 0.0f, 254.5f / 255);
    const float light =
        grey <= 0.04045f ? grey / 12.92f : attenuation(2.4f * negativeLog((grey + 0.055f) / 1.055f)).left;
    return depthThatTakes(light);
}

template <FlatModel Model>
PDR_HD inline Projected projected(const FlatScene& scene, const RayResult<float>& found, vec3 behind) {
    const bool kept = found.exceeded == 0;
    if constexpr (Model == FlatModel::maximumIntensity) {
        const float light = windowed(scene.optics, found.value[0]);
        return {vec3(light), kept, light > 0};
    }
    const vec3 gathered(found.value[0], found.value[1], found.value[2]);
    return {gathered + found.left * behind, kept, found.left < 1 || gathered != vec3(0)};
}

/// Returns the result of a ray that meets nothing.
template <FlatModel Model>
PDR_HD inline Projected projectedMiss(const FlatScene& scene, vec3 behind) {
    RayResult<float> nothing;
    if constexpr (Model == FlatModel::maximumIntensity)
        nothing.value[0] = -float(kMipBias);
    return projected<Model>(scene, nothing, behind);
}

/// Walks along one ray to its end.
template <FlatModel Model, Tissue Kind>
PDR_HD inline Projected projectAlong(const FlatScene& scene, const Ray& ray, vec3 behind) {
    RayWalk<float, Model, Kind> walk;
    walk.start(scene, {ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z},
               ray.length);
    while (walk.going())
        walk.step(scene);
    return projected<Model>(scene, walk.result(), behind);
}

template <FlatModel Model>
PDR_HD inline Projected project(const FlatScene& scene, const Ray& ray, vec3 behind) {
    return forProjectedTissue<Model>(scene,
                                     [&]<Tissue Kind>() { return projectAlong<Model, Kind>(scene, ray, behind); });
}

}  // namespace pdr
