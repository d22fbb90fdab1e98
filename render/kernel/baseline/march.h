#pragma once
/// Ray marching as Exposure Render (Kroes, Post & Botha 2012) does it: BIASED. It serves for comparison and as a
/// negative control: tests of the unbiased trackers must fail with it. No image for use is made with it.
///   A fixed step with a jittered start; the extinction at a sample stands for the whole step; the ray collides at the
///   first sample where the summed optical depth reaches -ln(u). Shadows are a second march, with a result of 0 or 1.
/// The bias: a slab is hit by a whole number of samples. Through 2.5 steps of tissue the transmittance is too high by
/// cosh(extinction * step / 2) - 1: 3 % where extinction * step is 0.5, 54 % at 2, 513 % at 5.

#include <cmath>

#include "render/kernel/medium.h"
#include "render/kernel/random.h"
#include "render/kernel/ray.h"

namespace pdr {

inline constexpr float kExposureRenderStep = 3;  ///< voxels

/// Returns the length of a step of `voxels` [mm]. Exposure Render takes as one voxel the volume's longest side divided
/// by its largest number of voxels along any side. For equal spacings along all axes this is the spacing; for the head
/// of 256 x 230 x 256 voxels of 0.98 x 1.4 x 0.98 mm it is 1.26 mm.
PDR_HD inline float marchStep(const FlatVolume& volume, float voxels) {
    float longest = 0;
    int most = 1;
    for (int axis = 0; axis < 3; ++axis) {
        longest = glm::max(longest, glm::length(volume.localFromIndex[axis]) * float(volume.size[axis]));
        most = glm::max(most, volume.size[axis]);
    }
    return voxels * longest / float(most);
}

/// Limit on the samples of a march: with steps of 3 voxels even the longest ray through the largest volume has 40,000.
inline constexpr int kMostMarchSamples = 1 << 20;

/// The end of a march, and the number of samples of the volume that it took.
struct MarchEnd {
    float distance;  ///< mm from the ray's origin; -1: the ray left the volume; NaN: no end (see march)
    int samples;
};

/// Marches along a ray in steps of `step` [mm], above 0. A ray that is not finite, or longer than kMostMarchSamples
/// steps, has no valid end: its distance is NaN, so that the sample of the image is rejected and counted
/// (Fault::notANumber).
PDR_HD inline MarchEnd march(const FlatScene& scene, const Ray& ray, RandomStream random, float step) {
    const Interval<float> inside =
        clipped(ray.origin, ray.direction, vec3(-0.5f), scene.volume.lastIndex + 0.5f, Interval<float>{0, ray.length});
    const vec2 u = random.pair();
    float depth = negativeLog(u.x);
    const bool finite =
        step > 0 && step + glm::dot(ray.origin, ray.origin) + glm::dot(ray.direction, ray.direction) < 1e38f;
    for (int i = 0; finite && i < kMostMarchSamples; ++i) {
        const float t = inside.enter + (float(i) + u.y) * step;
        if (!(t < inside.leave))
            return {-1, i};
        depth -= extinction(scene, ray.origin + ray.direction * t) * step;
        if (depth <= 0)
            return {t, i + 1};
    }
    return {NAN, 0};
}

/// Returns the distance of the first collision [mm], -1, or NaN. Biased: too deep on average.
PDR_HD inline float marchToCollision(const FlatScene& scene, const Ray& ray, const RandomStream& random, float step) {
    return march(scene, ray, random, step).distance;
}

/// Returns 1 if the march leaves the volume, 0 if it collides, or NaN. Biased: too bright on average.
PDR_HD inline float marchTransmittance(const FlatScene& scene, const Ray& ray, const RandomStream& random, float step) {
    const float collision = march(scene, ray, random, step).distance;
    return collision < 0 ? 1.0f : 0 * collision;
}

}  // namespace pdr
