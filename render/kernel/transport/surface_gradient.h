#pragma once
/// The gradients that make surfaces: of the HU, of where tissue is hidden, and of where parts end.

#include "render/kernel/gradient.h"
#include "render/kernel/medium.h"

namespace pdr {

/// HU that stand for clipped and hidden tissue: those of air.
inline constexpr float kHiddenHu = -1000;

/// Returns the gradient of the visible tissue [HU/mm] at a position with `hu`. Hidden tissue counts as air, so that
/// visible tissue has a surface at the border of the mask.
PDR_HD inline vec3 seenGradient(const FlatScene& scene, vec3 position, float hu) {
    const vec3 gradient = hounsfieldGradient(scene.volume, position);
    const float weight = isMasked(scene) ? weightAt(scene, position) : 1;
    if (!(weight < 1))
        return gradient;
    return weight * gradient + glm::max(hu - kHiddenHu, 0.0f) * weightGradient(scene, position);
}

/// HU by which a part whose shape is that of its labels differs from what is around it: water against air.
inline constexpr float kLabelStepHu = 1000;

/// Returns the gradient at the edge of such a part [HU/mm]: of the share of its labels. Its own HU are those of what it
/// stands for, or lies in, and have no edge there.
PDR_HD inline vec3 labelGradient(const FlatScene& scene, const FlatTransferFunction& curve, vec3 position) {
    const FlatParts& parts = scene.parts;
    return kLabelStepHu * splineGradient(scene.volume, position, [&](std::int64_t voxel) {
               return parts.curves[parts.materialOf[parts.labels[voxel]]].firstPiece == curve.firstPiece ? 1.0f : 0.0f;
           });
}

/// HU by which tissue that ends with its part differs from what is around it, besides what the HU say. Noise is far
/// less, edges that the HU show are more.
inline constexpr float kPartStepHu = 200;

/// Returns whether all voxels that splineGradient() reads at a position have one curve.
PDR_HD inline bool isWithinPart(const FlatScene& scene, vec3 position) {
    const ivec3 fine = scene.majorants.fineSize, last(scene.volume.lastIndex), corner(glm::floor(position));
    const ivec3 low = glm::clamp(corner - 1, ivec3(0), last) / kFineCell + 1;
    const ivec3 high = glm::clamp(corner + 2, ivec3(0), last) / kFineCell + 1;
    const int only = scene.parts.onlyCurve[cellIndex(low, fine)];
    bool within = only != kMixedCell;
    for (int k = low.z; k <= high.z; ++k)
        for (int j = low.y; j <= high.y; ++j)
            for (int i = low.x; i <= high.x; ++i)
                within = within && scene.parts.onlyCurve[cellIndex({i, j, k}, fine)] == only;
    return within;
}

/// Returns the gradient [HU/mm] of where tissue of `curve` ends with its part: of its share where other parts are less
/// opaque at `hu`. Towards parts that are as opaque it has no end.
PDR_HD_INLINE vec3 partGradient(const FlatScene& scene, const FlatTransferFunction& curve, vec3 position, float hu) {
    const FlatParts& parts = scene.parts;
    const float whole = extinctionOf(curve, hu);
    if (!(whole > 0) || isWithinPart(scene, position))
        return vec3(0);
    int known = -1;
    float share = 0;
    return kPartStepHu * splineGradient(scene.volume, position, [&](std::int64_t voxel) {
               const int number = parts.curveOf[parts.labels[voxel]];
               if (number != known)
                   share = glm::min(extinctionOf(parts.curves[number], hu) / whole, 1.0f);
               known = number;
               return share;
           });
}

/// Returns the gradient that makes surfaces in tissue of `curve` at a position with `hu` [HU/mm]. Where the HU show no
/// edge of a part, their gradient is that of the noise, and the part's own end outweighs it.
PDR_HD inline vec3 surfaceGradient(const FlatScene& scene, const FlatTransferFunction& curve, vec3 position, float hu) {
    if (curve.surfaceFactor < 0)
        return labelGradient(scene, curve, position);
    const vec3 seen = seenGradient(scene, position, hu);
    if (!hasParts(scene))
        return seen;
    const vec3 part = partGradient(scene, curve, position, hu);
    return part + (glm::dot(part, seen) < 0 ? -seen : seen);
}

}  // namespace pdr
