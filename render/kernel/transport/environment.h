#pragma once
/// The environment light: the same in all directions, a gradient from the zenith (towards the head) to the nadir, or an
/// image. An image is latitude-longitude: rows from the zenith down, the middle of a row towards the back (+y), its
/// right end by way of the patient's left (+x). The radiance is constant within a texel.

#include "render/kernel/flat_scene.h"
#include "render/kernel/intervals.h"
#include "render/kernel/transport/lights.h"
#include "render/kernel/turns.h"

namespace pdr {

/// Returns the index of the texel in `direction` (unit, local).
PDR_HD inline int environmentTexel(const FlatEnvironment& environment, vec3 direction) {
    const float turns = turnsTo(direction.y, direction.x) - environment.turn + 0.5f;
    const float across = turns - std::floor(turns);
    const float down = 2 * turnsTo(direction.z, glm::length(vec2(direction)));
    const ivec2 size = environment.size;
    const int column = glm::min(int(across * float(size.x)), size.x - 1);
    const int row = glm::min(int(down * float(size.y)), size.y - 1);
    return row * size.x + column;
}

/// Returns the radiance of a gradient from `direction` (unit, local).
template <class Real>
PDR_HD inline Vec3<Real> gradientRadiance(const FlatEnvironment& environment, const Vec3<Real>& direction) {
    return environment.nadir + (environment.zenith - environment.nadir) * (0.5f + 0.5f * direction.z);
}

/// Returns the radiance that arrives from `direction` (unit, local).
PDR_HD inline vec3 environmentRadiance(const FlatEnvironment& environment, vec3 direction) {
    if (environment.texels != nullptr)
        return environment.texels[environmentTexel(environment, direction)] * environment.zenith;
    return gradientRadiance(environment, direction);
}

/// Returns the pdf with which sampleEnvironment finds `direction` [1/sr]; 0 without an image.
PDR_HD inline float environmentPdf(const FlatEnvironment& environment, vec3 direction) {
    return environment.texels != nullptr ? environment.pdf[environmentTexel(environment, direction)] : 0;
}

#if !defined(__CUDACC__)

/// Return those of lanes of directions. There must be no image.
inline Vec3<FloatLanes> environmentRadiance(const FlatEnvironment& environment, const Vec3<FloatLanes>& direction) {
    return gradientRadiance(environment, direction);
}
inline FloatLanes environmentPdf(const FlatEnvironment&, const Vec3<FloatLanes>&) {
    return FloatLanes{};
}

#endif

/// Samples a direction in proportion to the light of the image's texels, uniformly within a texel's solid angle.
PDR_HD inline LightSample sampleEnvironment(const FlatEnvironment& environment, vec2 choice, vec2 place) {
    const ivec2 size = environment.size;
    const int row = intervalOf(environment.rowSums, size.y, choice.x);
    const int column = intervalOf(environment.columnSums + std::ptrdiff_t(row) * (size.x + 1), size.x, choice.y);
    const float top = circlePoint(0.5f * float(row) / float(size.y)).cosine;
    const float bottom = circlePoint(0.5f * float(row + 1) / float(size.y)).cosine;
    const float z = top + (bottom - top) * place.y;
    const float sine = std::sqrt(glm::max((1 - z) * (1 + z), 0.0f));
    const auto around = circlePoint((float(column) + place.x) / float(size.x) - 0.5f + environment.turn);
    const int texel = row * size.x + column;
    const float density = environment.pdf[texel];
    if (!(density > 0))
        return dark<float>();
    return {{sine * around.sine, sine * around.cosine, z},
            kFarAway,
            environment.texels[texel] * environment.zenith / density,
            density};
}

}  // namespace pdr
