#pragma once
/// One sample as Exposure Render (Kroes, Post & Botha 2012) takes it: BIASED, for comparison only, see march.h.
///   kept     a march in steps of 3 voxels to a single event, and a second march from there to the light, which is then
///            visible or not; one of all lights, chosen uniformly and weighted by the number of lights
///   ours     the transfer function and its extinction, surfaces and the phase function, lights and camera, random
///            numbers: two images then differ by the estimator alone
///   omitted  its second light sample along the scattered direction, and with it the wrong weights between the two; its
///            phase function, which is twice too bright

#include "render/kernel/baseline/march.h"
#include "render/kernel/transport/integrator.h"

namespace pdr {

namespace kroes {

/// All features: effects that a scene does not need change nothing.
inline constexpr std::uint32_t kAll = kFeatureMasks - 1;

PDR_HD inline bool isLight(const FlatEnvironment& environment) {
    return environment.zenith != vec3(0) || environment.nadir != vec3(0);
}

/// Samples an environment image in proportion to its light, and an environment without an image uniformly.
PDR_HD inline LightSample sampleSurroundings(const FlatEnvironment& environment, RandomStream random) {
    const vec2 u = random.pair();
    if (environment.texels != nullptr)
        return sampleEnvironment(environment, u, random.pair());
    const vec3 wi = phaseSample(0, vec3(0, 0, -1), u);
    return {wi, kFarAway, environmentRadiance(environment, wi) / kInverseFourPi, kInverseFourPi};
}

/// Samples light that reaches the event from one of the lights.
PDR_HD inline LightPath lightOfOne(const FlatScene& scene, const Event& event, const Sampler& sampler) {
    const int lights = scene.lightCount + (isLight(scene.environment) ? 1 : 0);
    if (lights == 0)
        return {{event.position, vec3(0), 0}, vec3(0)};
    const float choice = sampler.number(0, BounceDimension::choice);
    const int picked = glm::min(int(choice * float(lights)), lights - 1);
    const LightSample light =
        picked < scene.lightCount
            ? sampleLight<kAll>(scene.lights[picked], localPosition(scene.volume, event.position),
                                sampler.pair(0, BounceDimension::light))
            : sampleSurroundings(scene.environment, sampler.stream(0, BounceDimension::environment));
    const vec3 wi = scene.volume.indexFromLocal * light.wi;
    const bool cutAway = scene.clip.count > 0 && !scene.clip.shadows;
    const float distance = cutAway ? cutLength(scene.clip, event.position, wi, light.distance) : light.distance;
    return {{event.position, wi, scene.unshadowed ? 0 : distance},
            scatterEval<kAll>(scene, event, light.wi) * light.radiance * float(lights)};
}

}  // namespace kroes

/// Returns one sample of `pixel`. `depths`: where tissue lies along the pixel's view; see FlatViewBounds. They do not
/// change what a march finds on average: its first step is jittered by a whole step.
PDR_HD inline PathSample kroesSample(const FlatScene& scene, ivec2 pixel, std::uint64_t sample, vec2 depths) {
    // March to the event.
    const Path path = startPath(scene, pixel, sample, depths);
    const float step = marchStep(scene.volume, kExposureRenderStep);
    const float collision =
        marchToCollision(scene, path.segment.ray, path.sampler.stream(0, BounceDimension::distance), step);
    PathSample result;
    if (!(collision >= 0)) {
        result.radiance = missed(scene, path.segment, collision);
        return result;
    }
    // Shade the event and march to the light.
    result.tissue = true;
    const Event event = eventAt<kroes::kAll>(scene, path.segment.ray.origin + path.segment.ray.direction * collision,
                                             -path.segment.direction, path.sampler.number(0, BounceDimension::event));
    result.radiance = event.material.emission;
    const LightPath light = kroes::lightOfOne(scene, event, path.sampler);
    if (isDark(light))
        return result;
    const float left = marchTransmittance(scene, light.ray, path.sampler.stream(0, BounceDimension::shadow), step);
    addLight(result, light.radiance, left);
    return result;
}

}  // namespace pdr
