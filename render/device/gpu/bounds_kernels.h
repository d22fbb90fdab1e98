#pragma once
/// Builds the acceleration structure on the device: ranges, majorants, and the depth bounds of the view. The numbers
/// are bit by bit those that prepare/majorants and prepare/view_bounds make on the host.

#include <climits>

#include "render/device/gpu/atomic.h"
#include "render/kernel/bounds/part_bound.h"
#include "render/kernel/bounds/view_footprint.h"
#include "render/kernel/quadrature/ray_maximum.h"

namespace pdr {

/// Computes the HU range of each fine cell.
struct BuildRangesKernel {
    const std::int16_t* voxels;
    ivec3 size, fine;
    HuRange* ranges;

    PDR_HD void operator()(std::int64_t index) const { ranges[index] = rangeOfCell(voxels, size, cellAt(index, fine)); }
};

/// What the host must know of the bounds.
struct BoundsSummary {
    std::int32_t low[3] = {INT_MAX, INT_MAX, INT_MAX};   ///< lowest fine cell with a bound above 0, along each axis
    std::int32_t high[3] = {INT_MIN, INT_MIN, INT_MIN};  ///< highest fine cell with a bound above 0, along each axis
    std::int32_t highest = 0;                            ///< bits of the largest bound
};

/// Computes the bound of each fine cell.
struct BoundFineKernel {
    const HuRange* ranges;
    FlatTransferFunction function;
    float highestOfCurve;
    bool highestHu;  ///< whether the bounds are those of HU, for maximumIntensity
    FlatMask mask;
    FlatParts parts;
    ivec3 volume;  ///< size in voxels
    ivec3 fineGrid;
    float* fine;

    PDR_HD static float curveBound(const FlatTransferFunction& curve, HuRange range, float highest) {
        return extinctionBound(curve.extinctionPerMm, highestOpacity(curve, range), highest);
    }
    PDR_HD float bound(HuRange range, ivec3 cell) const {
        if (highestHu)
            return highestHuBound(range, mask, volume, cell);
        float whole = 0;
        if (parts.labels == nullptr)
            whole = curveBound(function, range, highestOfCurve);
        else
            forCurvesIn(parts, volume, fineGrid, cell, [&](int curve) {
                whole = glm::max(whole, curveBound(parts.curves[curve], range, highestOpacity(parts.curves[curve])));
            });
        return whole > 0 && mask.voxels != nullptr ? maskedBound(whole, highestWeight(mask, volume, cell)) : whole;
    }

    PDR_HD void operator()(std::int64_t index) const { fine[index] = bound(ranges[index], cellAt(index, fineGrid)); }
};

/// Computes the bound of each coarse cell from those of its fine cells.
struct BoundCoarseKernel {
    const float* fine;
    ivec3 coarseGrid;
    float* coarse;
    BoundsSummary* summary;

    PDR_HD void operator()(std::int64_t index) const {
        const ivec3 first = cellAt(index, coarseGrid) * kFinePerCoarse, fineGrid = coarseGrid * kFinePerCoarse;
        ivec3 low(INT_MAX), high(INT_MIN);
        float most = 0;
        for (int n = 0; n < 64; ++n) {
            const ivec3 cell = first + ivec3(n & 3, (n >> 2) & 3, n >> 4);
            const float here = fine[cellIndex(cell, fineGrid)];
            if (!(here > 0))
                continue;
            most = glm::max(most, here);
            low = glm::min(low, cell);
            high = glm::max(high, cell);
        }
        coarse[index] = most;
        if (!(most > 0))
            return;
        for (int axis = 0; axis < 3; ++axis) {
            atomicLower(summary->low[axis], low[axis]);
            atomicRaise(summary->high[axis], high[axis]);
        }
        atomicRaise(summary->highest, bitsOf(most));
    }
};

/// Converts floats to whole numbers in the same order, and back.
PDR_HD inline std::int32_t orderedBits(float x) {
    const std::int32_t bits = bitsOf(x);
    return bits >= 0 ? bits : bits ^ INT_MAX;
}
PDR_HD inline float fromOrderedBits(std::int32_t ordered) {
    return floatOf(ordered >= 0 ? ordered : ordered ^ INT_MAX);
}

/// The depths of a block of pixels as ordered bits, while cells are added to it.
struct OrderedDepths {
    std::int32_t nearest, farthest;

    PDR_HD void include(const CoveredBlocks& covered) {
        atomicLower(nearest, orderedBits(covered.nearest));
        atomicRaise(farthest, orderedBits(covered.farthest));
    }
};

/// Counts cells that cover so many blocks that one thread should not go through them alone.
struct WideCells {
    static constexpr int kRoom = 16384;
    static constexpr int kManyBlocks = 64;
    static constexpr int kThreads = 32;  ///< threads that share the blocks of a wide cell

    std::int32_t count = 0;
    std::int32_t behind = 0;  ///< 1: some cell reaches behind the eye
};

/// Empties the depths of each block.
struct ClearDepthsKernel {
    OrderedDepths* depths;

    PDR_HD void operator()(std::int64_t index) const {
        depths[index] = {orderedBits(floatOf(0x7F800000)), orderedBits(-floatOf(0x7F800000))};
    }
};

/// Adds each fine cell to the blocks that it covers, or to the list of wide cells.
struct ProjectCellsKernel {
    FlatMajorants grid;
    ViewProjection projection;
    FlatClip clip;
    ivec2 film, blocks;
    OrderedDepths* depths;
    WideCells* wide;
    CoveredBlocks* wideCells;  ///< room for WideCells::kRoom cells

    PDR_HD void cover(const CoveredBlocks& covered) const {
        for (int y = covered.first.y; y <= covered.last.y; ++y)
            for (int x = covered.first.x; x <= covered.last.x; ++x)
                depths[std::int64_t(y) * blocks.x + x].include(covered);
    }

    PDR_HD void operator()(std::int64_t index) const {
        const ivec3 cell = cellAt(index, grid.fineSize);
        if (!(grid.fine[index] > 0) || cutAway(clip, cell))
            return;
        bool behind;
        const Footprint footprint = footprintOf(projection, cell, behind);
        if (behind) {
            atomicRaise(wide->behind, 1);
            return;
        }
        const CoveredBlocks covered(footprint, film, blocks);
        const ivec2 extent = covered.last - covered.first + 1;
        const bool many = extent.x > 0 && extent.x * extent.y > WideCells::kManyBlocks;
        const std::int32_t place = many ? atomicTakeNext(wide->count) : WideCells::kRoom;
        if (place < WideCells::kRoom)
            wideCells[place] = covered;
        else
            cover(covered);
    }
};

/// Adds each wide cell to the blocks that it covers. Index: one of a cell's threads, cell by cell.
struct SpreadWideCellsKernel {
    const WideCells* wide;
    const CoveredBlocks* wideCells;
    ivec2 blocks;
    OrderedDepths* depths;

    PDR_HD void operator()(std::int64_t index) const {
        const auto number = std::int32_t(index / WideCells::kThreads);
        if (number >= wide->count || wide->behind != 0)
            return;
        const CoveredBlocks covered = wideCells[number];
        const ivec2 extent = covered.last - covered.first + 1;
        for (int n = int(index % WideCells::kThreads); n < extent.x * extent.y; n += WideCells::kThreads) {
            const ivec2 block = covered.first + ivec2(n % extent.x, n / extent.x);
            depths[std::int64_t(block.y) * blocks.x + block.x].include(covered);
        }
    }
};

/// Writes the depths of each block as the kernel reads them.
struct ViewDepthsKernel {
    const OrderedDepths* ordered;
    const WideCells* wide;
    vec2* depths;

    PDR_HD void operator()(std::int64_t index) const {
        if (wide->behind != 0)
            depths[index] = vec2(0, floatOf(0x7F800000));
        else
            depths[index] = vec2(fromOrderedBits(ordered[index].nearest), fromOrderedBits(ordered[index].farthest));
    }
};

}  // namespace pdr
