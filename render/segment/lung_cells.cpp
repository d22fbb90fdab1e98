#include "render/segment/lung_cells.h"

#include "render/segment/cell_values.h"
#include "render/segment/pieces.h"

namespace pdr::segment {
namespace {

constexpr int kAirHu = -400;     ///< cells below it may be lung
constexpr int kGasHu = -970;     ///< bowel gas below it, lung above it
constexpr double kLungMl = 150;  ///< least volume of a lung

}  // namespace

Cells lungCells(const Volume& volume, const BodyMask& body, const Checkpoint& checkpoint) {
    const CellGrid& grid = body.grid;
    const std::vector<std::int32_t> sums = cellSums(volume, grid, checkpoint);
    Cells air = cellsAbove(kAirHu, sums, grid);
    for (std::size_t i = 0; i < air.size(); ++i)
        air[i] = body.body[i] && !air[i];
    const Cells tissue = cellsAbove(kGasHu, sums, grid);
    checkpoint();
    // Count the cells of each piece of air, and those that are no pure gas
    const Pieces pieces = piecesOf(air, grid);
    checkpoint();
    std::vector<std::size_t> size(std::size_t(pieces.count) + 1), notGas(size.size());
    for (std::size_t i = 0; i < air.size(); ++i) {
        ++size[std::size_t(pieces.of[i])];
        notGas[std::size_t(pieces.of[i])] += tissue[i];
    }
    // Keep the large pieces that are mostly lung
    Cells lung(air.size());
    for (std::size_t i = 0; i < air.size(); ++i) {
        const auto piece = std::size_t(pieces.of[i]);
        lung[i] = air[i] && double(size[piece]) * grid.cellMl() >= kLungMl && 2 * notGas[piece] > size[piece];
    }
    return lung;
}

}  // namespace pdr::segment
