#pragma once
/// The connected pieces of a mask. Cells hang together where they share a face.

#include <vector>

#include "render/segment/cell_grid.h"

namespace pdr::segment {

struct Pieces {
    std::vector<std::int32_t> of;  ///< for each cell the number of its piece; 0: not in the mask
    int count = 0;                 ///< pieces have the numbers 1 to count, in the order of their first cells
};

Pieces piecesOf(const Cells& mask, const CellGrid& grid);

/// The pieces of `mask` that hold at least `least` of the cells of `seeds`; > 0.
Cells piecesWith(const Cells& seeds, double least, const Cells& mask, const CellGrid& grid);

/// The pieces of `mask` that hold a ball of `radiusMm`, by the squared depths of its cells [mm^2].
struct ThickPieces {
    Cells cells;
    int count = 0;
};
ThickPieces thickPieces(const Cells& mask, const std::vector<float>& squaredDepths, const CellGrid& grid,
                        double radiusMm);

}  // namespace pdr::segment
