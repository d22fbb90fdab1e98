#include "render/prepare/highest_along.h"

#include <cmath>

#include "render/kernel/quadrature/ray_maximum.h"

namespace pdr {

namespace {

template <bool Masked>
std::optional<HighestAlong> highestOf(const FlatScene& scene, const Ray& ray) {
    constexpr int kSteps = 8;
    std::optional<HighestAlong> highest;
    CellWalk<float> walk;
    walk.start(scene.majorants, {ray.origin.x, ray.origin.y, ray.origin.z},
               {ray.direction.x, ray.direction.y, ray.direction.z}, ray.length);
    while (walk.walking()) {
        // Voxels are whole numbers: only a cell with a voxel above this can hold more.
        const float bar = highest ? std::floor(highest->hu) + kMipBias : 0.0f;
        std::conditional_t<Masked, MaskedHuAlong<float>, HuAlong<float>> way{};
        if (!walk.step(scene, true, bar, way))
            continue;
        const float begin = walk.reached() - way.length;
        for (int i = 0; i <= kSteps; ++i) {
            const float s = float(i) / kSteps;
            if constexpr (Masked)
                if (way.weight.at(s) < kSeenFrom)
                    continue;
            if (const float hu = way.hu.at(s); !highest || hu > highest->hu)
                highest = HighestAlong{hu, begin + s * way.length};
        }
    }
    return highest;
}

}  // namespace

std::optional<HighestAlong> highestAlong(const FlatScene& scene, const Ray& ray) {
    return isMasked(scene) ? highestOf<true>(scene, ray) : highestOf<false>(scene, ray);
}

}  // namespace pdr
