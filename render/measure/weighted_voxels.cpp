#include "render/measure/weighted_voxels.h"

#include <algorithm>

namespace pdr::measure {

void WeightedVoxels::add(dvec3 mm, double weight) {
    eachCorner(grid_.size, grid_.index(mm), [&](ivec3 voxel, double share) {
        auto& [at, sum] = weights_[grid_.offset(voxel)];
        at = voxel;
        sum += weight * share;
    });
}

double WeightedVoxels::variance(const Noise& noise) const {
    double together = 0, independent = 0;
    for (const auto& [offset, entry] : weights_) {
        const auto& a = entry;
        independent += a.second * a.second * noise.variance();
        noise.eachLag([&](ivec3 lag) {
            const ivec3 other = a.first + lag;
            if (glm::any(glm::lessThan(other, ivec3(0))) || glm::any(glm::greaterThanEqual(other, grid_.size)))
                return;
            const auto b = weights_.find(grid_.offset(other));
            if (b != weights_.end())
                together += a.second * b->second.second * noise.covariance(lag);
        });
    }
    return std::max(together, independent);
}

}  // namespace pdr::measure
