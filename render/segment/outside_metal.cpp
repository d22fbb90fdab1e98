#include "render/segment/outside_metal.h"

#include "render/segment/cell_values.h"
#include "render/segment/pieces.h"
#include "render/segment/rule.h"

namespace pdr::segment {
namespace {

/// Returns the cells that are not in `shown` and hold a voxel of metal.
Cells metalBeside(const Cells& shown, const Volume& volume, const CellGrid& grid, const Checkpoint& checkpoint) {
    const CellValues values = cellValues(volume, grid, checkpoint);
    Cells metal(grid.count());
    for (std::size_t i = 0; i < metal.size(); ++i)
        metal[i] = !shown[i] && values.highest[i] > kMetalHu;
    return metal;
}

}  // namespace

double showMetal(const Volume& volume, BodyMask& mask, const Checkpoint& checkpoint) {
    const CellGrid& grid = mask.grid;
    const Cells solid = cellsAbove(kSolidHu, cellSums(volume, grid, checkpoint), grid);
    const Cells metal = metalBeside(mask.shown, volume, grid, checkpoint);
    Cells beside = grown(metal, grid, checkpoint);  // thin wires have gaps where cells are larger than the wires
    for (std::size_t i = 0; i < beside.size(); ++i)
        beside[i] = !mask.shown[i] && (beside[i] || solid[i]);
    const Cells kept = piecesWith(metal, 1, beside, grid, checkpoint);
    const Cells around = grown(kept, grid, checkpoint);
    checkpoint();
    Cells held = mask.body, counted = kept;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        counted[i] = kept[i] && (solid[i] || metal[i]);
        mask.shown[i] |= kept[i] || (around[i] && !solid[i]);
        mask.cut[i] = mask.cut[i] && !kept[i];
        held[i] |= kept[i];
    }
    mask.box = boxOf(held, grid);
    mask.rowEnds = rowEnds(held, grid);
    return volumeMl(counted, grid);
}

}  // namespace pdr::segment
