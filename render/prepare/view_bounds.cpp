#include "render/prepare/view_bounds.h"

#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <limits>

#include "render/kernel/bounds/view_footprint.h"

namespace pdr {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Calls visit(cell) for each fine cell with a bound above 0 in a slab of coarse cells, until it returns false.
template <class Visit>
void forOccupiedCells(const FlatMajorants& grid, int slab, Visit&& visit) {
    const auto at = [](const float* values, ivec3 size, ivec3 cell) {
        return values[(std::size_t(cell.z) * size.y + cell.y) * size.x + cell.x];
    };
    for (int J = 0; J < grid.coarseSize.y; ++J)
        for (int I = 0; I < grid.coarseSize.x; ++I) {
            if (!(at(grid.coarse, grid.coarseSize, {I, J, slab}) > 0))
                continue;
            for (int n = 0; n < 64; ++n) {
                const ivec3 cell(4 * I + (n & 3), 4 * J + ((n >> 2) & 3), 4 * slab + (n >> 4));
                if (at(grid.fine, grid.fineSize, cell) > 0 && !visit(cell))
                    return;
            }
        }
}

vec2 united(vec2 a, vec2 b) {
    return {std::min(a.x, b.x), std::max(a.y, b.y)};
}

/// Adds the depths that the occupied cells of a slab cover to `depths`. Returns false if a cell reaches behind the eye.
bool cover(const FlatScene& scene, const ViewProjection& projection, int slab, std::vector<vec2>& depths) {
    const ivec2 film = scene.camera.film, blocks = viewBlocks(film);
    bool behind = false;
    forOccupiedCells(scene.majorants, slab, [&](ivec3 cell) {
        if (cutAway(scene.clip, cell))
            return true;
        const Footprint footprint = footprintOf(projection, cell, behind);
        if (behind)
            return false;
        const CoveredBlocks covered(footprint, film, blocks);
        for (int y = covered.first.y; y <= covered.last.y; ++y)
            for (int x = covered.first.x; x <= covered.last.x; ++x) {
                vec2& depth = depths[std::size_t(y) * blocks.x + x];
                depth = united(depth, {covered.nearest, covered.farthest});
            }
        return true;
    });
    return !behind;
}

bool sameView(const FlatCamera& a, const FlatCamera& b) {
    return a.film == b.film && a.perspective == b.perspective && a.eye == b.eye && a.forward == b.forward &&
           a.right == b.right && a.up == b.up && a.lensRight == b.lensRight && a.lensUp == b.lensUp &&
           a.focus == b.focus;
}

bool samePlanes(const FlatClip& a, const FlatClip& b) {
    const auto same = [](const FlatPlane& p, const FlatPlane& q) {
        return p.normal == q.normal && p.offset == q.offset;
    };
    return std::equal(a.planes, a.planes + a.count, b.planes, b.planes + b.count, same);
}

/// Returns whether the same fine cells of two grids of one size have a bound above 0.
bool sameOccupied(const FlatMajorants& a, const FlatMajorants& b) {
    if (a.fine == b.fine)
        return true;
    const std::size_t perSlab = std::size_t(a.fineSize.x) * std::size_t(a.fineSize.y) * kFinePerCoarse;
    std::atomic<bool> differ = false;
    tbb::parallel_for(0, a.coarseSize.z, [&](int slab) {
        if (differ)
            return;
        const float *first = a.fine + std::size_t(slab) * perSlab, *second = b.fine + std::size_t(slab) * perSlab;
        int differing = 0;  // no early end: all cells are compared at once
        for (std::size_t i = 0; i < perSlab; ++i)
            differing |= int(first[i] > 0) ^ int(second[i] > 0);
        if (differing)
            differ = true;
    });
    return !differ;
}

}  // namespace

std::vector<vec2> viewDepths(const FlatScene& scene) {
    const ViewProjection projection(scene);
    const ivec2 blocks = viewBlocks(scene.camera.film);
    const std::size_t count = std::size_t(blocks.x) * std::size_t(blocks.y);
    const auto none = [&] { return std::vector<vec2>(count, vec2(kInfinity, -kInfinity)); };
    tbb::combinable<std::vector<vec2>> ofThreads(none);
    std::atomic<bool> behindEye = false;
    tbb::parallel_for(0, scene.majorants.coarseSize.z, [&](int slab) {
        if (!behindEye && !cover(scene, projection, slab, ofThreads.local()))
            behindEye = true;
    });
    if (behindEye)
        return std::vector<vec2>(count, vec2(0, kInfinity));
    std::vector<vec2> depths = none();
    ofThreads.combine_each([&](const std::vector<vec2>& some) {
        std::transform(depths.begin(), depths.end(), some.begin(), depths.begin(), united);
    });
    return depths;
}

bool sameViewDepths(const FlatScene& a, const FlatScene& b) {
    return sameView(a.camera, b.camera) && samePlanes(a.clip, b.clip) && sameOccupied(a.majorants, b.majorants);
}

}  // namespace pdr
