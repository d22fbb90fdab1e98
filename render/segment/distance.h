#pragma once
/// How far cells lie from others.

#include <vector>

#include "render/segment/cell_grid.h"
#include "render/segment/checkpoint.h"

namespace pdr::segment {

/// Of distances that are not known any more, as they are beyond what was asked for.
inline constexpr float kFar = 1e30f;

/// Whether a squared distance [mm^2] is at least, or at most, that of `mm`; rounding decides nothing.
inline bool atLeast(float squaredMm2, double mm) {
    return double(squaredMm2) >= mm * mm * (1 - 1e-6);
}
inline bool atMost(float squaredMm2, double mm) {
    return double(squaredMm2) <= mm * mm * (1 + 1e-6);
}

/// For each cell the squared distance [mm^2] from its centre to that of the nearest cell whose flag is `value`. Exact
/// up to `reachMm`; beyond, at least the square of `reachMm`, also where there is none. What lies outside the grid is
/// no cell. The same for any number of threads, and of a mirrored mask the mirrored one, bit by bit.
std::vector<float> squaredDistances(const Cells& cells, std::uint8_t value, const CellGrid& grid, double reachMm,
                                    const Checkpoint& checkpoint = goOn);

/// `cells`, and all whose centre lies at most `radiusMm` from that of one of them.
Cells widened(const Cells& cells, const CellGrid& grid, double radiusMm, const Checkpoint& checkpoint = goOn);

}  // namespace pdr::segment
