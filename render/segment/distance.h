#pragma once
/// Distances between cells.

#include <vector>

#include "render/segment/cell_grid.h"
#include "render/segment/checkpoint.h"

namespace pdr::segment {

/// The value of squared distances that are not known, as they are beyond the requested reach.
inline constexpr float kFar = 1e30f;

/// Returns whether a squared distance [mm^2] is at least, or at most, that of `mm`, with a tolerance for rounding.
inline bool atLeast(float squaredMm2, double mm) {
    return double(squaredMm2) >= mm * mm * (1 - 1e-6);
}
inline bool atMost(float squaredMm2, double mm) {
    return double(squaredMm2) <= mm * mm * (1 + 1e-6);
}

/// Returns for each cell the squared distance [mm^2] from its centre to that of the nearest cell whose flag is `value`.
/// Exact up to `reachMm`; beyond, and where there is no such cell, at least the square of `reachMm`. There are no cells
/// outside the grid. On a sheared grid, distances to the cells of other layers are linear between those that lie where
/// the layers are crossed: right to half the edge of a cell. The result is the same for any number of threads, and
/// mirrored, bit by bit, for a mirrored mask.
std::vector<float> squaredDistances(const Cells& cells, std::uint8_t value, const CellGrid& grid, double reachMm,
                                    const Checkpoint& checkpoint = goOn);

/// Returns `cells` and all cells whose centre lies at most `radiusMm` from that of one of them.
Cells widened(const Cells& cells, const CellGrid& grid, double radiusMm, const Checkpoint& checkpoint = goOn);

}  // namespace pdr::segment
