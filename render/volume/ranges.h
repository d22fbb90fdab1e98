#pragma once
/// Smallest and largest HU per small cell of a volume, from which bounds on the extinction are made for any curve.
///   cells    base/cells.h    order    x fastest, then y, then z    values    Hounsfield units

#include "render/base/cells.h"
#include "render/base/huge_pages.h"
#include "render/volume/volume.h"

namespace pdr {

class CellRanges {
  public:
    explicit CellRanges(const Volume& volume);

    ivec3 fineSize() const { return coarseSize_ * kFinePerCoarse; }
    ivec3 coarseSize() const { return coarseSize_; }
    const HugePageVector<HuRange>& cells() const { return cells_; }
    /// Returns the range over all cells, which a transfer function's table must span.
    HuRange whole() const { return whole_; }

  private:
    ivec3 coarseSize_;
    HugePageVector<HuRange> cells_;
    HuRange whole_ = kEmptyRange;
};

}  // namespace pdr
