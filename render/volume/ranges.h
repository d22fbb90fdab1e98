#pragma once
/// Smallest and largest HU per small cell of a volume: what a bound on the extinction is made from, for any curve.
///   cell (i,j,k) holds the points whose index coordinates lie in [4(i-1), 4i] x [4(j-1), 4j] x [4(k-1), 4k]: cell
///   borders run through voxel centres, so that trilinear interpolation inside a cell meets 5 voxels an axis and no
///   more. The first layer catches the half voxel outside the first centres. order    x fastest, then y, then z values
///   Hounsfield units
/// The grid is padded to whole coarse cells of 4 x 4 x 4 fine ones; cells that no point of the volume lies in are
/// kEmpty.

#include <cstdint>
#include <vector>

#include "render/volume/volume.h"

namespace pdr {

inline constexpr int kFineCell = 4;       ///< voxels along an edge of a fine cell
inline constexpr int kFinePerCoarse = 4;  ///< fine cells along an edge of a coarse cell

struct HuRange {
    std::int16_t lowest;
    std::int16_t highest;
    bool operator==(const HuRange&) const = default;
};

class CellRanges {
  public:
    static constexpr HuRange kEmpty{INT16_MAX, INT16_MIN};

    explicit CellRanges(const Volume& volume);

    ivec3 fineSize() const { return coarseSize_ * kFinePerCoarse; }
    ivec3 coarseSize() const { return coarseSize_; }
    const std::vector<HuRange>& cells() const { return cells_; }
    /// Over all cells; what a transfer function's table must span.
    HuRange whole() const { return whole_; }

  private:
    ivec3 coarseSize_;
    std::vector<HuRange> cells_;
    HuRange whole_ = kEmpty;
};

}  // namespace pdr
