#pragma once
/// The negative control: a slab seen straight on as Exposure Render estimates it (Kroes, Post & Botha 2012), which the
/// self-test must find wrong. A fixed step with a jittered start; the extinction at a sample stands for the whole step;
/// a shadow is another such march, seen or not seen.

#include "app/bench/selftest_verdict.h"
#include "render/kernel/medium.h"
#include "render/kernel/random.h"
#include "render/kernel/ray.h"
#include "tests/support/statistics.h"

namespace pdr::test {

/// Distance of the first collision [mm], or -1.
inline float marchToCollision(const FlatScene& scene, const Ray& ray, RandomStream random, float step) {
    const vec2 u = random.pair();
    float depth = negativeLog(u.x);
    for (float t = u.y * step; t < ray.length; t += step) {
        depth -= extinction(scene, ray.origin + ray.direction * t) * step;
        if (depth <= 0)
            return t;
    }
    return -1;
}

/// `samples` marches straight down into a slab of `thickness` mm in steps of `step` mm, and from there up to the beam:
/// its reflectance factor.
inline bench::Measurement marchedReflectance(const bench::Case& slab, const FlatScene& scene, float thickness,
                                             float step, int samples) {
    const float cosine = float(slab.scene.beam.value());
    const vec3 top = vec3(0.5f, 0.5f, 1) * scene.volume.lastIndex + vec3(0, 0, 0.5f);
    const vec3 down = scene.volume.indexFromLocal * vec3(0, 0, -1);
    const vec3 towards = scene.volume.indexFromLocal * vec3(std::sqrt(1 - cosine * cosine), 0, cosine);
    Sample reflected;
    for (int i = 0; i < samples; ++i) {
        const Random random(3, std::uint32_t(i), 0);
        const float hit =
            marchToCollision(scene, {top, down, thickness}, random.stream(0, BounceDimension::flight), step);
        const Ray shadow{top + down * hit, towards, hit / cosine};
        const bool lit =
            hit >= 0 && marchToCollision(scene, shadow, random.stream(0, BounceDimension::shadow), step) < 0;
        reflected.add(lit ? slab.scene.albedo / (4 * cosine) : 0);
    }
    return {reflected.mean(), reflected.standardError()};
}

/// The same for what gets straight through.
inline bench::Measurement marchedTransmittance(const FlatScene& scene, float thickness, float step, int samples) {
    const vec3 top = vec3(0.5f, 0.5f, 1) * scene.volume.lastIndex + vec3(0, 0, 0.5f);
    const Ray ray{top, scene.volume.indexFromLocal * vec3(0, 0, -1), thickness};
    Sample through;
    for (int i = 0; i < samples; ++i) {
        const RandomStream random = Random(3, std::uint32_t(i), 0).stream(0, BounceDimension::flight);
        through.add(marchToCollision(scene, ray, random, step) < 0);
    }
    return {through.mean(), through.standardError()};
}

}  // namespace pdr::test
