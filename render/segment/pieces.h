#pragma once
/// The connected pieces of a mask. Cells are connected where they share a face.

#include <vector>

#include "render/segment/cell_grid.h"
#include "render/segment/checkpoint.h"

namespace pdr::segment {

struct Pieces {
    std::vector<std::int32_t> of;  ///< number of the piece of each cell; 0: not in the mask
    int count = 0;                 ///< number of pieces; they are numbered 1 to count, by their first cells
};

Pieces piecesOf(const Cells& mask, const CellGrid& grid, const Checkpoint& checkpoint = goOn);

/// Returns the pieces of `mask` that hold at least `least` > 0 of the cells of `seeds`.
Cells piecesWith(const Cells& seeds, double least, const Cells& mask, const CellGrid& grid,
                 const Checkpoint& checkpoint = goOn);

/// The pieces of a mask that hold a ball of some radius, by the squared depths of the mask's cells [mm^2].
struct ThickPieces {
    Cells cells;
    int count = 0;
};
ThickPieces thickPieces(const Cells& mask, const std::vector<float>& squaredDepths, const CellGrid& grid,
                        double radiusMm, const Checkpoint& checkpoint = goOn);

}  // namespace pdr::segment
