#pragma once
/// Computes majorants, all of them or those that an edit of a curve changes.

#include <span>

#include "render/prepare/curve_bound.h"
#include "render/prepare/majorants.h"

namespace pdr {

/// What bounds are computed from.
struct BoundedTissue {
    const CellRanges& ranges;
    ivec3 volumeSize;
    HighestWeights& weights;  ///< those of the mask
    FlatParts parts;
    std::span<const CurveBound> curves;  ///< those of curveBounds()
};

/// Returns the range of HU in each coarse cell.
HugePageVector<HuRange> coarseRanges(const CellRanges& ranges);

/// Computes all bounds, in the memory of those before.
void boundAll(Majorants& majorants, const BoundedTissue& tissue);

/// Brings bounds up to date that are those of the tissue but for cells that hold HU of `changed`. `coarse`: see
/// coarseRanges().
void boundChanged(Majorants& majorants, const BoundedTissue& tissue, const HugePageVector<HuRange>& coarse,
                  HuRange changed);

}  // namespace pdr
