#pragma once
/// The grid on which a scan is divided into parts of the patient and other things: blocks of whole voxels.
///   cell (i,j,k)  voxels [i, i + 1) x block.x and so on; the last cell along an axis may hold fewer
///   order         x fastest, then y, then z
/// A cell's edge is as near to 2 mm as whole voxels allow: at 2 mm a patient of any scan has a few million cells, and a
/// table's shell is still separate from the skin.

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
    ivec3 voxels{0};       ///< voxels of the volume
    dvec3 spacingMm{1.0};  ///< between the layers of cells along i, j, k
    dvec2 driftMm{0};      ///< how far each layer along k lies sideways of the one before, along i and j

    static CellGrid over(const VolumeGeometry& geometry);

    std::size_t count() const { return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z); }
    std::size_t sliceCount() const { return std::size_t(size.x) * std::size_t(size.y); }
    std::size_t index(int x, int y, int z) const {
        return (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x) + std::size_t(x);
    }
    /// Returns the number of voxels in a cell.
    int voxelsIn(ivec3 cell) const {
        const ivec3 edges = glm::min(block, voxels - cell * block);
        return edges.x * edges.y * edges.z;
    }
    /// Returns the volume of a whole cell: sideways drift leaves it as it is.
    double cellMl() const { return spacingMm.x * spacingMm.y * spacingMm.z / 1000; }
    /// Returns the longest edge of a cell.
    double longestMm() const { return glm::max(spacingMm.x, glm::max(spacingMm.y, spacingMm.z)); }
};

/// Returns the volume of the flagged cells; those at the end of an axis count by the voxels that they hold.
double volumeMl(const Cells& cells, const CellGrid& grid);

}  // namespace pdr::segment
