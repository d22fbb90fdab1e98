#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>

#include "render/kernel/bounds/mask_bound.h"
#include "render/kernel/bounds/part_bound.h"
#include "render/prepare/majorants.h"
#include "render/prepare/opacity_maximum.h"

namespace pdr {

namespace {

/// The index-space box of all fine cells with a bound above 0; empty (low > high) if there are none.
struct Box {
    vec3 low{1e30f}, high{-1e30f};

    void include(ivec3 cell) {
        low = glm::min(low, lowCorner(cell));
        high = glm::max(high, highCorner(cell));
    }
};

/// Bounds on the extinction of one curve.
class CurveBound {
  public:
    CurveBound(const FlatTransferFunction& curve, HuRange domain)
        : maximum_(curve, domain), extinctionPerMm_(curve.extinctionPerMm), highest_(highestOpacity(curve)) {}

    float over(HuRange range) const { return extinctionBound(extinctionPerMm_, maximum_.over(range), highest_); }
    /// Sets the bounds over `count` ranges.
    void over(const HuRange* ranges, float* __restrict bounds, int count) const {
        for (int i = 0; i < count; ++i)
            bounds[i] = over(ranges[i]);
    }

  private:
    OpacityMaximum maximum_;
    float extinctionPerMm_, highest_;
};

std::vector<CurveBound> curveBounds(const FlatTransferFunction& common, const FlatParts& parts, HuRange domain) {
    std::vector<CurveBound> bounds;
    bounds.reserve(std::size_t(std::max(parts.curveCount, 1)));
    for (int i = 0; i < parts.curveCount; ++i)
        bounds.emplace_back(parts.curves[i], domain);
    if (bounds.empty())
        bounds.emplace_back(common, domain);
    return bounds;
}

/// Raises the bounds of the coarse cells of a row to those of its `count` fine cells.
void raise(const float* fine, int count, float* coarse) {
    for (int i = 0; i < count / kFinePerCoarse; ++i) {
        const float* four = fine + i * kFinePerCoarse;
        coarse[i] = std::max({coarse[i], four[0], four[1], four[2], four[3]});
    }
}

/// Bounds the fine cells of a slab, row by row by boundRow(first range, first bound, first cell), and the coarse ones,
/// which are 0. Returns the box of all above 0.
template <class BoundRow>
Box boundSlab(Majorants& majorants, const CellRanges& ranges, int slab, const BoundRow& boundRow) {
    static_assert(kFinePerCoarse == 4);
    const ivec3 size = ranges.fineSize(), coarseSize = ranges.coarseSize();
    const auto isSeen = [](float bound) { return bound > 0; };
    Box box;
    for (int k = slab * kFinePerCoarse; k < (slab + 1) * kFinePerCoarse; ++k)
        for (int j = 0; j < size.y; ++j) {
            const std::size_t row = (std::size_t(k) * size.y + j) * size.x;
            const std::span<float> fine(&majorants.fine[row], std::size_t(size.x));
            boundRow(&ranges.cells()[row], fine.data(), ivec3(0, j, k));
            const auto first = std::ranges::find_if(fine, isSeen);
            if (first == fine.end())
                continue;
            const auto last = std::find_if(fine.rbegin(), fine.rend(), isSeen);
            box.include({int(first - fine.begin()), j, k});
            box.include({int(fine.rend() - last) - 1, j, k});
            raise(fine.data(), size.x,
                  &majorants.coarse[(std::size_t(slab) * coarseSize.y + j / kFinePerCoarse) * coarseSize.x]);
        }
    return box;
}

}  // namespace

void Majorants::compute(const CellRanges& ranges, const TransferTables& tables, ivec3 volumeSize,
                        HighestWeights& weights, const FlatParts& parts) {
    const ivec3 size = ranges.fineSize(), coarseSize = ranges.coarseSize();
    fine.resize(ranges.cells().size());
    coarse.assign(std::size_t(coarseSize.x) * coarseSize.y * coarseSize.z, 0.0f);
    const std::vector<CurveBound> curves = curveBounds(tables.flat(), parts, ranges.whole());
    const auto boundOfParts = [&](HuRange range, ivec3 cell) {
        float most = 0;
        forCurvesIn(parts, volumeSize, size, cell,
                    [&](int curve) { most = std::max(most, curves[std::size_t(curve)].over(range)); });
        return most;
    };
    const auto boundRow = [&](const HuRange* cells, float* bounds, ivec3 first) {
        const auto cellAt = [first](int i) { return ivec3(i, first.y, first.z); };
        if (parts.labels == nullptr)
            curves[0].over(cells, bounds, size.x);
        else
            for (int i = 0; i < size.x; ++i)
                bounds[i] = boundOfParts(cells[i], cellAt(i));
        for (int i = 0; weights.hasMask() && i < size.x; ++i)
            if (bounds[i] > 0)
                bounds[i] = maskedBound(bounds[i], weights.at(cellAt(i)));
    };
    // Bound the fine and coarse cells, slab by slab in parallel.
    std::vector<Box> boxes(coarseSize.z);
    tbb::parallel_for(0, coarseSize.z, [&](int slab) { boxes[slab] = boundSlab(*this, ranges, slab, boundRow); });
    // Unite the boxes of the slabs and clip them to the volume.
    Box all;
    for (const Box& box : boxes) {
        all.low = glm::min(all.low, box.low);
        all.high = glm::max(all.high, box.high);
    }
    occupiedLow = glm::max(all.low, vec3(-0.5f));
    occupiedHigh = glm::min(all.high, vec3(volumeSize) - 0.5f);
}

}  // namespace pdr
