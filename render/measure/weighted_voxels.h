#pragma once
/// A linear combination of voxels, such as an interpolated or averaged value, and how noise propagates to it.

#include <unordered_map>

#include "render/measure/noise.h"
#include "render/measure/trilinear.h"

namespace pdr::measure {

class WeightedVoxels {
  public:
    explicit WeightedVoxels(const GridPlace& grid) : grid_(grid) {}

    /// Adds the interpolated value at a place, times `weight`.
    void add(dvec3 mm, double weight);
    /// Returns the variance that `noise` brings [HU^2]: at least that of independent voxels.
    double variance(const Noise& noise) const;

  private:
    const GridPlace& grid_;
    std::unordered_map<std::size_t, std::pair<ivec3, double>> weights_;
};

}  // namespace pdr::measure
