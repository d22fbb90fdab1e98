#pragma once
/// Bounds on the extinction of tissue from the HU that a cell holds, for the curves of a scene.

#include <vector>

#include "render/kernel/bounds/part_bound.h"
#include "render/prepare/opacity_maximum.h"

namespace pdr {

/// Overlaps all ranges of cells, even those of cells without voxels.
inline constexpr HuRange kAnyHu{INT16_MIN, INT16_MAX};

/// Bounds on the extinction of one curve.
class CurveBound {
  public:
    /// `domain`: range within which all intervals lie.
    CurveBound(const FlatTransferFunction& curve, HuRange domain)
        : maximum_(curve, domain), extinctionPerMm_(curve.extinctionPerMm), highest_(highestOpacity(curve)) {}

    float over(HuRange range) const { return extinctionBound(extinctionPerMm_, maximum_.over(range), highest_); }
    /// Sets the bounds over `count` ranges.
    void over(const HuRange* ranges, float* __restrict bounds, int count) const;

    /// Returns a range without which the bounds over an interval are those of `before`, bit by bit; both have one
    /// domain.
    HuRange changedFrom(const CurveBound& before) const {
        const bool isScaled = extinctionPerMm_ != before.extinctionPerMm_ || highest_ != before.highest_;
        return isScaled ? kAnyHu : maximum_.changedFrom(before.maximum_);
    }

  private:
    OpacityMaximum maximum_;
    float extinctionPerMm_, highest_;
};

/// Returns the bounds of the curves of the parts, or of the only curve where there are no parts.
std::vector<CurveBound> curveBounds(const FlatTransferFunction& common, const FlatParts& parts, HuRange domain);

}  // namespace pdr
