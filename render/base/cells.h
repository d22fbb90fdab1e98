#pragma once
/// Cells of the grid for which bounds are stored, and the voxels that matter in each.
///   cell (i,j,k) holds the points whose index coordinates lie in [4(i-1), 4i] x [4(j-1), 4j] x [4(k-1), 4k]: cell
///   borders run through voxel centres, so that trilinear interpolation inside a cell reads only 5 voxels along each
///   axis. The first layer covers the half voxel outside the first centres.
/// The grid is padded to whole coarse cells of 4 x 4 x 4 fine ones; cells that contain no point of the volume are
/// kEmptyRange.

#include <cstdint>

#include "render/base/portable.h"

namespace pdr {

inline constexpr int kFineCell = 4;       ///< voxels along an edge of a fine cell
inline constexpr int kFinePerCoarse = 4;  ///< fine cells along an edge of a coarse cell

struct HuRange {
    std::int16_t lowest;
    std::int16_t highest;
    bool operator==(const HuRange&) const = default;

    PDR_HD void include(HuRange other) {
        lowest = glm::min(lowest, other.lowest);
        highest = glm::max(highest, other.highest);
    }
    PDR_HD bool empty() const { return lowest > highest; }
};
inline constexpr HuRange kEmptyRange{INT16_MAX, INT16_MIN};

/// Returns the number of coarse cells along an axis of `voxels` voxels.
PDR_HD inline int coarseCells(int voxels) {
    // The last point of the volume lies at index coordinate voxels - 0.5, in fine cell (voxels - 1) / 4 + 1.
    const int fine = (voxels - 1) / kFineCell + 2;
    return (fine + kFinePerCoarse - 1) / kFinePerCoarse;
}

PDR_HD inline ivec3 coarseCells(ivec3 voxels) {
    return {coarseCells(voxels.x), coarseCells(voxels.y), coarseCells(voxels.z)};
}

/// Voxels that interpolation can read along one axis inside a cell: [first, last]; empty if first > last.
struct VoxelSpan {
    int first, last;
};

PDR_HD inline VoxelSpan voxelsOfCell(int c, int size) {
    const int begin = kFineCell * (c - 1);
    if (begin >= size)
        return {1, 0};
    return {glm::max(begin, 0), glm::clamp(begin + kFineCell, 0, size - 1)};
}

/// Returns the smallest and the largest value that interpolation can reach in a fine cell. `voxels`: x fastest, then y,
/// then z.
PDR_HD inline HuRange rangeOfCell(const std::int16_t* voxels, ivec3 size, ivec3 cell) {
    const VoxelSpan x = voxelsOfCell(cell.x, size.x), y = voxelsOfCell(cell.y, size.y),
                    z = voxelsOfCell(cell.z, size.z);
    HuRange range = kEmptyRange;
    for (int k = z.first; k <= z.last; ++k)
        for (int j = y.first; j <= y.last; ++j) {
            const std::int16_t* row = voxels + (std::int64_t(k) * size.y + j) * size.x;
            for (int i = x.first; i <= x.last; ++i)
                range.include({row[i], row[i]});
        }
    return range;
}

/// Returns the index of a cell in a grid, x fastest, then y, then z; cellAt() is the inverse.
PDR_HD inline std::int64_t cellIndex(ivec3 cell, ivec3 grid) {
    return (std::int64_t(cell.z) * grid.y + cell.y) * grid.x + cell.x;
}

PDR_HD inline ivec3 cellAt(std::int64_t index, ivec3 grid) {
    const std::int64_t row = index / grid.x;
    return {int(index % grid.x), int(row % grid.y), int(row / grid.y)};
}

}  // namespace pdr
