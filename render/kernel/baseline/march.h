#pragma once
/// Ray marching as Exposure Render (Kroes, Post & Botha 2012) does it: BIASED. Kept for comparison, and so that tests
/// of the unbiased trackers can be seen to fail (negative control); no picture that counts is made with it.
///   A fixed step with a jittered start; the extinction at a sample stands for the whole step; the ray collides at the
///   first sample where the summed optical depth reaches -ln(u). Shadows are that march again, seen or not seen.
/// What is wrong with it: a slab is met by a whole number of samples. Through 2.5 steps of tissue the transmittance is
/// too high by cosh(extinction * step / 2) - 1: 3 % where extinction * step is 0.5, 54 % at 2, 513 % at 5.

#include <cmath>

#include "render/kernel/medium.h"
#include "render/kernel/random.h"
#include "render/kernel/ray.h"

namespace pdr {

inline constexpr float kExposureRenderStep = 3;  ///< voxels

/// A step of that many `voxels` [mm], as Exposure Render measures them: the volume's longest side over its largest
/// number of voxels along any side. Of an even grid that is its spacing; the head of 256 x 230 x 256 voxels of 0.98 x
/// 1.4 x 0.98 mm has 1.26 mm.
PDR_HD inline float marchStep(const FlatVolume& volume, float voxels) {
    float longest = 0;
    int most = 1;
    for (int axis = 0; axis < 3; ++axis) {
        longest = glm::max(longest, glm::length(volume.localFromIndex[axis]) * float(volume.size[axis]));
        most = glm::max(most, volume.size[axis]);
    }
    return voxels * longest / float(most);
}

/// No march takes more samples: with steps of 3 voxels even the longest way through the largest volume has 40,000.
inline constexpr int kMostMarchSamples = 1 << 20;

/// Where a march ended, and after how many samples of the volume.
struct MarchEnd {
    float distance;  ///< mm from the ray's origin; -1: it left the volume; NaN: it came to no end (see march)
    int samples;
};

/// `step`: mm, above 0. A way that is not finite, or longer than kMostMarchSamples steps, has no end that could be
/// told: its distance is no number, so that the picture's sample is none either and is counted (Fault::notANumber).
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

/// Distance of the first collision [mm], -1, or NaN. Biased: on average too deep.
PDR_HD inline float marchToCollision(const FlatScene& scene, const Ray& ray, const RandomStream& random, float step) {
    return march(scene, ray, random, step).distance;
}

/// 1 where the march gets through, else 0, or NaN. Biased: on average too bright.
PDR_HD inline float marchTransmittance(const FlatScene& scene, const Ray& ray, const RandomStream& random, float step) {
    const float collision = march(scene, ray, random, step).distance;
    return collision < 0 ? 1.0f : 0 * collision;
}

}  // namespace pdr
