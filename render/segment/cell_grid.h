#pragma once
/// The grid on which a scan is divided into parts of the patient and other things: blocks of whole voxels.
///   cell (i,j,k)  voxels [i, i + 1) x block.x and so on; the last cell along an axis may hold fewer
///   order         x fastest, then y, then z
/// A cell's edge is as near to 2 mm as whole voxels allow: at 2 mm a patient of any scan has a few million cells, and
/// a table's shell is still apart from the skin.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/volume/volume.h"

namespace pdr::segment {

/// A flag for each cell: 0 or 1.
using Cells = std::vector<std::uint8_t>;

struct CellGrid {
    ivec3 size{0};         ///< cells along i, j, k
    ivec3 block{1};        ///< voxels along the edges of a cell
    dvec3 spacingMm{1.0};  ///< between the centres of cells

    static CellGrid over(const VolumeGeometry& geometry);

    std::size_t count() const { return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z); }
    std::size_t sliceCount() const { return std::size_t(size.x) * std::size_t(size.y); }
    std::size_t index(int x, int y, int z) const {
        return (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x) + std::size_t(x);
    }
    /// Of a whole cell.
    double cellMl() const { return spacingMm.x * spacingMm.y * spacingMm.z / 1000; }
    /// The longest edge of a cell.
    double longestMm() const { return glm::max(spacingMm.x, glm::max(spacingMm.y, spacingMm.z)); }
};

/// Of the flagged cells of a scan of that many voxels; cells at the end of an axis count as large as they are.
double volumeMl(const Cells& cells, const CellGrid& grid, ivec3 voxels);

/// The cells whose mean lies above `thresholdHu`; what lies below air counts as air.
Cells cellsAbove(int thresholdHu, const Volume& volume, const CellGrid& grid);

}  // namespace pdr::segment
