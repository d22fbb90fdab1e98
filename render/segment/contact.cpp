#include "render/segment/contact.h"

#include <algorithm>

#include "render/segment/distance.h"
#include "render/segment/outline.h"
#include "render/segment/pieces.h"
#include "render/segment/rule.h"

namespace pdr::segment {
namespace {

/// The size of one piece.
struct Extent {
    std::size_t cells = 0;
    ivec3 first{INT32_MAX}, last{INT32_MIN};

    double lengthMm(const dvec3& spacing) const {
        const dvec3 edges = dvec3(last - first + 1) * spacing;
        return glm::max(edges.x, glm::max(edges.y, edges.z));
    }
};

std::vector<Extent> extentsOf(const Pieces& pieces, const CellGrid& grid) {
    std::vector<Extent> extents(std::size_t(pieces.count) + 1);
    std::size_t i = 0;
    for (int z = 0; z < grid.size.z; ++z)
        for (int y = 0; y < grid.size.y; ++y)
            for (int x = 0; x < grid.size.x; ++x, ++i)
                if (pieces.of[i] != 0) {
                    Extent& extent = extents[std::size_t(pieces.of[i])];
                    ++extent.cells;
                    extent.first = glm::min(extent.first, ivec3(x, y, z));
                    extent.last = glm::max(extent.last, ivec3(x, y, z));
                }
    return extents;
}

/// Returns the body's core: an erosion by 3 mm, without pieces that do not hold the ball.
Cells eroded(const Cells& body, const std::vector<float>& squaredDepths, const CellGrid& grid,
             const Checkpoint& checkpoint) {
    Cells cells(body.size());
    for (std::size_t i = 0; i < body.size(); ++i)
        cells[i] = body[i] && atLeast(squaredDepths[i], kOpeningMm);
    return thickPieces(cells, squaredDepths, grid, kBallMm, checkpoint).cells;
}

/// Returns the residue of the opening: what lies farther from the core than the erosion took.
Cells residueOf(const Cells& body, const std::vector<float>& squaredDepths, const CellGrid& grid,
                const Checkpoint& checkpoint) {
    const double reach = kOpeningMm + 1.01 * grid.longestMm();
    const std::vector<float> fromCore =
        squaredDistances(eroded(body, squaredDepths, grid, checkpoint), 1, grid, reach, checkpoint);
    checkpoint();
    Cells residue(body.size());
    for (std::size_t i = 0; i < body.size(); ++i)
        residue[i] = body[i] && !atMost(fromCore[i], reach);
    return residue;
}

/// Returns the cells of the pieces whose number is in `chosen`.
Cells cellsOf(const Pieces& pieces, const Cells& chosen) {
    Cells cells(pieces.of.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        cells[i] = chosen[std::size_t(pieces.of[i])];
    return cells;
}

Cells without(const Cells& body, const Cells& taken) {
    Cells rest(body.size());
    for (std::size_t i = 0; i < body.size(); ++i)
        rest[i] = body[i] && !taken[i];
    return rest;
}

/// Removes enclosed pieces from `foreign`: vessels are long and thin too, but lie inside.
void keepEnclosed(Cells& foreign, const Pieces& pieces, const std::vector<Extent>& extents, const Cells& body,
                  const CellGrid& grid, const Checkpoint& checkpoint) {
    const Cells outline = withHolesFilled(without(body, cellsOf(pieces, foreign)), grid, checkpoint);
    checkpoint();
    std::vector<std::size_t> inside(extents.size());
    for (std::size_t i = 0; i < outline.size(); ++i)
        inside[std::size_t(pieces.of[i])] += outline[i];
    for (std::size_t piece = 1; piece < foreign.size(); ++piece)
        if (2 * inside[piece] > extents[piece].cells)
            foreign[piece] = 0;
}

}  // namespace

Cells touching(const Cells& body, const std::vector<float>& squaredDepths, const CellGrid& grid,
               const Checkpoint& checkpoint) {
    const Cells residue = residueOf(body, squaredDepths, grid, checkpoint);
    const auto all = double(std::count(body.begin(), body.end(), 1));
    const auto thin = double(std::count(residue.begin(), residue.end(), 1));
    if (all - thin < kLeastOpened * all)
        return Cells(body.size());

    checkpoint();
    // Keep its long pieces that lie outside the rest
    const Pieces pieces = piecesOf(residue, grid, checkpoint);
    checkpoint();
    const std::vector<Extent> extents = extentsOf(pieces, grid);
    checkpoint();
    Cells foreign(extents.size());
    for (std::size_t piece = 1; piece < extents.size(); ++piece)
        foreign[piece] = double(extents[piece].cells) * grid.cellMl() >= kResidueMl &&
                         extents[piece].lengthMm(grid.spacingMm) >= kResidueMm;
    keepEnclosed(foreign, pieces, extents, body, grid, checkpoint);
    return cellsOf(pieces, foreign);
}

}  // namespace pdr::segment
