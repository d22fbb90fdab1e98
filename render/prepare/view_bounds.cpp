#include "render/prepare/view_bounds.h"

#include <limits>

#include "render/kernel/bounds/view_footprint.h"

namespace pdr {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Calls visit(cell) for each fine cell with a bound above 0, until it returns false.
template <class Visit>
void forOccupiedCells(const FlatMajorants& grid, Visit&& visit) {
    const auto at = [](const float* values, ivec3 size, ivec3 cell) {
        return values[(std::size_t(cell.z) * size.y + cell.y) * size.x + cell.x];
    };
    for (int K = 0; K < grid.coarseSize.z; ++K)
        for (int J = 0; J < grid.coarseSize.y; ++J)
            for (int I = 0; I < grid.coarseSize.x; ++I) {
                if (!(at(grid.coarse, grid.coarseSize, {I, J, K}) > 0))
                    continue;
                for (int n = 0; n < 64; ++n) {
                    const ivec3 cell(4 * I + (n & 3), 4 * J + ((n >> 2) & 3), 4 * K + (n >> 4));
                    if (at(grid.fine, grid.fineSize, cell) > 0 && !visit(cell))
                        return;
                }
            }
}

}  // namespace

std::vector<vec2> viewDepths(const FlatScene& scene) {
    const ViewProjection projection(scene);
    const ivec2 film = scene.camera.film, blocks = viewBlocks(film);
    std::vector<vec2> depths(std::size_t(blocks.x) * blocks.y, vec2(kInfinity, -kInfinity));
    forOccupiedCells(scene.majorants, [&](ivec3 cell) {
        if (cutAway(scene.clip, cell))
            return true;
        bool behind;
        const Footprint footprint = footprintOf(projection, cell, behind);
        if (behind) {
            depths.assign(depths.size(), vec2(0, kInfinity));
            return false;
        }
        const CoveredBlocks covered(footprint, film, blocks);
        for (int y = covered.first.y; y <= covered.last.y; ++y)
            for (int x = covered.first.x; x <= covered.last.x; ++x) {
                vec2& depth = depths[std::size_t(y) * blocks.x + x];
                depth = {std::min(depth.x, covered.nearest), std::max(depth.y, covered.farthest)};
            }
        return true;
    });
    return depths;
}

}  // namespace pdr
