#include "render/prepare/majorants.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "render/kernel/bounds/mask_bound.h"
#include "render/prepare/bound_cells.h"

namespace pdr {

namespace {

/// Sets the bounds of `count` fine cells of a row, from `first` on.
void boundRow(const BoundedTissue& tissue, ivec3 first, int count, float* bounds) {
    const ivec3 size = tissue.ranges.fineSize();
    const HuRange* cells = &tissue.ranges.cells()[std::size_t(cellIndex(first, size))];
    const auto cellOf = [first](int i) { return ivec3(first.x + i, first.y, first.z); };
    const auto boundOfParts = [&](HuRange range, ivec3 cell) {
        float most = 0;
        forCurvesIn(tissue.parts, tissue.volumeSize, size, cell,
                    [&](int curve) { most = std::max(most, tissue.curves[std::size_t(curve)].over(range)); });
        return most;
    };
    if (tissue.parts.labels == nullptr)
        tissue.curves[0].over(cells, bounds, count);
    else
        for (int i = 0; i < count; ++i)
            bounds[i] = boundOfParts(cells[i], cellOf(i));
    for (int i = 0; tissue.weights.hasMask() && i < count; ++i)
        if (bounds[i] > 0)
            bounds[i] = maskedBound(bounds[i], tissue.weights.at(cellOf(i)));
}

/// Raises the bounds of the coarse cells of a row to those of its `count` fine cells.
void raise(const float* fine, int count, float* coarse) {
    for (int i = 0; i < count / kFinePerCoarse; ++i) {
        const float* four = fine + i * kFinePerCoarse;
        coarse[i] = std::max({coarse[i], four[0], four[1], four[2], four[3]});
    }
}

bool overlap(HuRange a, HuRange b) {
    return a.lowest <= b.highest && b.lowest <= a.highest;
}

/// Coarse cells of a row, side by side.
struct Run {
    int first, count;
};

/// Finds the runs of the coarse cells of a row that hold HU of `changed`.
void findChanged(std::span<const HuRange> row, HuRange changed, std::vector<Run>& runs) {
    runs.clear();
    const auto isChanged = [&](std::size_t i) { return i < row.size() && overlap(row[i], changed); };
    for (std::size_t i = 0, count = 0; i < row.size(); i += count + 1) {
        for (count = 0; isChanged(i + count);)
            ++count;
        if (count > 0)
            runs.push_back({int(i), int(count)});
    }
}

/// Bounds the coarse cells of some runs, in the row that begins with the cell `start`, and their fine cells: one row of
/// these after the other, as they lie in memory.
void boundRuns(Majorants& majorants, const BoundedTissue& tissue, ivec3 start, std::span<const Run> runs) {
    static_assert(kFinePerCoarse == 4);
    float* coarse = &majorants.coarse[std::size_t(cellIndex(start, tissue.ranges.coarseSize()))];
    for (const Run& run : runs)
        std::fill_n(coarse + run.first, run.count, 0.0f);  // raised below
    for (int k = 0; k < kFinePerCoarse; ++k)
        for (int j = 0; j < kFinePerCoarse; ++j)
            for (const Run& run : runs) {
                const int count = run.count * kFinePerCoarse;
                const ivec3 cell = (start + ivec3(run.first, 0, 0)) * kFinePerCoarse + ivec3(0, j, k);
                float* fine = &majorants.fine[std::size_t(cellIndex(cell, tissue.ranges.fineSize()))];
                boundRow(tissue, cell, count, fine);
                raise(fine, count, coarse + run.first);
            }
}

/// The fine cells from `low` to `high`; empty (low > high) without any.
struct CellBox {
    ivec3 low{INT32_MAX}, high{INT32_MIN};

    void include(ivec3 first, ivec3 last) {
        low = glm::min(low, first);
        high = glm::max(high, last);
    }
    bool contains(ivec3 first, ivec3 last) const {
        return glm::all(glm::lessThanEqual(low, first)) && glm::all(glm::lessThanEqual(last, high));
    }
};

/// Includes the fine cells with a bound above 0 of a coarse cell. Those of most cells add nothing to the box.
void includeOccupied(CellBox& box, const Majorants& majorants, ivec3 coarse, ivec3 fineSize) {
    const ivec3 first = coarse * kFinePerCoarse, last = first + (kFinePerCoarse - 1);
    if (box.contains(first, last))
        return;
    for (int k = first.z; k <= last.z; ++k)
        for (int j = first.y; j <= last.y; ++j)
            for (int i = first.x; i <= last.x; ++i)
                if (majorants.fine[std::size_t(cellIndex({i, j, k}, fineSize))] > 0)
                    box.include({i, j, k}, {i, j, k});
}

/// Finds the box of all fine cells with a bound above 0, and clips it to the volume.
void findOccupied(Majorants& majorants, const BoundedTissue& tissue) {
    const ivec3 size = tissue.ranges.coarseSize();
    CellBox all;
    for (std::size_t i = 0; i < majorants.coarse.size(); ++i)
        if (majorants.coarse[i] > 0)
            includeOccupied(all, majorants, cellAt(std::int64_t(i), size), tissue.ranges.fineSize());
    const bool isEmpty = all.low.x > all.high.x;
    const vec3 low = isEmpty ? vec3(1e30f) : lowCorner(all.low), high = isEmpty ? vec3(-1e30f) : highCorner(all.high);
    majorants.occupiedLow = glm::max(low, vec3(-0.5f));
    majorants.occupiedHigh = glm::min(high, vec3(tissue.volumeSize) - 0.5f);
}

}  // namespace

HugePageVector<HuRange> coarseRanges(const CellRanges& ranges) {
    const ivec3 size = ranges.coarseSize(), fine = ranges.fineSize();
    HugePageVector<HuRange> coarse(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    tbb::parallel_for(0, size.z, [&](int slab) {
        std::fill_n(&coarse[std::size_t(cellIndex({0, 0, slab}, size))], size.x * size.y, kEmptyRange);
        for (int k = slab * kFinePerCoarse; k < (slab + 1) * kFinePerCoarse; ++k)
            for (int j = 0; j < fine.y; ++j)
                for (int i = 0; i < fine.x; ++i)
                    coarse[std::size_t(cellIndex(ivec3(i, j, k) / kFinePerCoarse, size))].include(
                        ranges.cells()[std::size_t(cellIndex({i, j, k}, fine))]);
    });
    return coarse;
}

void boundAll(Majorants& majorants, const BoundedTissue& tissue) {
    const ivec3 size = tissue.ranges.coarseSize();
    majorants.fine.resize(tissue.ranges.cells().size());
    majorants.coarse.resize(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    tbb::parallel_for(0, size.z, [&](int slab) {
        const Run whole{0, size.x};
        for (int row = 0; row < size.y; ++row)
            boundRuns(majorants, tissue, {0, row, slab}, {&whole, 1});
    });
    findOccupied(majorants, tissue);
}

void boundChanged(Majorants& majorants, const BoundedTissue& tissue, const HugePageVector<HuRange>& coarse,
                  HuRange changed) {
    const ivec3 size = tissue.ranges.coarseSize();
    tbb::parallel_for(0, size.z, [&](int slab) {
        std::vector<Run> runs;
        for (int row = 0; row < size.y; ++row) {
            const ivec3 start(0, row, slab);
            findChanged({&coarse[std::size_t(cellIndex(start, size))], std::size_t(size.x)}, changed, runs);
            boundRuns(majorants, tissue, start, runs);
        }
    });
    findOccupied(majorants, tissue);
}

void Majorants::compute(const CellRanges& ranges, const TransferTables& tables, ivec3 volumeSize,
                        HighestWeights& weights, const FlatParts& parts) {
    boundAll(*this, {ranges, volumeSize, weights, parts, curveBounds(tables.flat(), parts, ranges.whole())});
}

}  // namespace pdr
