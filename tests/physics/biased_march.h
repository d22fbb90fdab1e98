#pragma once
/// The negative control: a slab seen straight on as Exposure Render estimates it (Kroes, Post & Botha 2012), which the
/// self-test must find wrong: marched to the event, and from there to the light.

#include "app/selftest/verdict.h"
#include "render/kernel/baseline/march.h"
#include "tests/support/statistics.h"

namespace pdr::test {

/// `samples` marches straight down into a slab of `thickness` mm in steps of `step` mm, and from there up to the beam:
/// its reflectance factor.
inline selftest::Measurement marchedReflectance(const selftest::Case& slab, const FlatScene& scene, float thickness,
                                                float step, int samples) {
    const float cosine = float(slab.scene.beam.value());
    const vec3 top = vec3(0.5f, 0.5f, 1) * scene.volume.lastIndex + vec3(0, 0, 0.5f);
    const vec3 down = scene.volume.indexFromLocal * vec3(0, 0, -1);
    const vec3 towards = scene.volume.indexFromLocal * vec3(std::sqrt(1 - cosine * cosine), 0, cosine);
    Sample reflected;
    for (int i = 0; i < samples; ++i) {
        const Random random(3, std::uint32_t(i), 0);
        const float hit =
            marchToCollision(scene, {top, down, thickness}, random.stream(0, BounceDimension::distance), step);
        const Ray shadow{top + down * hit, towards, hit / cosine};
        const float lit =
            hit >= 0 ? marchTransmittance(scene, shadow, random.stream(0, BounceDimension::shadow), step) : 0;
        reflected.add(lit * slab.scene.albedo / (4 * cosine));
    }
    return {reflected.mean(), reflected.standardError()};
}

/// Returns the transmittance of the same march: what gets straight through.
inline selftest::Measurement marchedTransmittance(const FlatScene& scene, float thickness, float step, int samples) {
    const vec3 top = vec3(0.5f, 0.5f, 1) * scene.volume.lastIndex + vec3(0, 0, 0.5f);
    const Ray ray{top, scene.volume.indexFromLocal * vec3(0, 0, -1), thickness};
    Sample through;
    for (int i = 0; i < samples; ++i) {
        const RandomStream random = Random(3, std::uint32_t(i), 0).stream(0, BounceDimension::distance);
        through.add(pdr::marchTransmittance(scene, ray, random, step));
    }
    return {through.mean(), through.standardError()};
}

}  // namespace pdr::test
