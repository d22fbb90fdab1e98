#include "render/segment/bone_cells.h"

#include <algorithm>

#include "render/segment/distance.h"
#include "render/segment/pieces.h"

namespace pdr::segment {
namespace {

constexpr int kDenseHu = 600;     ///< what is denser, on the mean of a cell, is bone
constexpr int kMarrowHu = 200;    ///< what is denser may be
constexpr double kReachMm = 8;    ///< so near to dense bone
constexpr double kClosedMm = 4;   ///< trabeculae and thin cortex leave gaps
constexpr double kLeastMl = 0.5;  ///< less dense bone in one piece is chalk in a vessel's wall, or noise

/// The pieces of `cells` of at least so many cells.
Cells largePieces(const Cells& cells, const CellGrid& grid, double leastCells) {
    const Pieces pieces = piecesOf(cells, grid);
    std::vector<std::size_t> sizes(std::size_t(pieces.count) + 1);
    for (const std::int32_t piece : pieces.of)
        ++sizes[std::size_t(piece)];
    Cells large(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        large[i] = cells[i] && double(sizes[std::size_t(pieces.of[i])]) >= leastCells;
    return large;
}

/// The pieces of `cells` in which some of `seeds` is set.
Cells piecesWith(const Cells& seeds, const Cells& cells, const CellGrid& grid) {
    const Pieces pieces = piecesOf(cells, grid);
    Cells holds(std::size_t(pieces.count) + 1);
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (seeds[i] && cells[i])
            holds[std::size_t(pieces.of[i])] = 1;
    Cells kept(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        kept[i] = cells[i] && holds[std::size_t(pieces.of[i])];
    return kept;
}

}  // namespace

Cells closed(const Cells& cells, const CellGrid& grid, double radiusMm) {
    std::vector<float> distances = squaredDistances(cells, 1, grid, radiusMm);
    Cells wide(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        wide[i] = atMost(distances[i], radiusMm);
    distances = squaredDistances(wide, 0, grid, radiusMm);
    for (std::size_t i = 0; i < cells.size(); ++i)
        wide[i] = cells[i] || (wide[i] && !atMost(distances[i], radiusMm));
    return wide;
}

Cells boneCells(const Volume& volume, const CellGrid& grid) {
    const Cells dense = largePieces(cellsAbove(kDenseHu, volume, grid), grid, kLeastMl / grid.cellMl());
    Cells near = cellsAbove(kMarrowHu, volume, grid);
    const std::vector<float> distances = squaredDistances(dense, 1, grid, kReachMm);
    for (std::size_t i = 0; i < near.size(); ++i)
        near[i] = near[i] && atMost(distances[i], kReachMm);
    return closed(piecesWith(dense, near, grid), grid, kClosedMm);
}

}  // namespace pdr::segment
