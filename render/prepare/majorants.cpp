#include <tbb/parallel_for.h>

#include <algorithm>

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

/// Bounds the fine cells of a slab, bound(range, cell), and the coarse ones, which are 0. Returns the box of all above
/// 0.
template <class Bound>
Box boundSlab(Majorants& majorants, const CellRanges& ranges, int slab, const Bound& bound) {
    const ivec3 size = ranges.fineSize(), coarseSize = ranges.coarseSize();
    Box box;
    for (int k = slab * kFinePerCoarse; k < (slab + 1) * kFinePerCoarse; ++k)
        for (int j = 0; j < size.y; ++j) {
            const std::size_t row = (std::size_t(k) * size.y + j) * size.x;
            float* above = &majorants.coarse[(std::size_t(slab) * coarseSize.y + j / kFinePerCoarse) * coarseSize.x];
            for (int i = 0; i < size.x; ++i) {
                const float here = bound(ranges.cells()[row + i], ivec3(i, j, k));
                majorants.fine[row + i] = here;
                if (!(here > 0))
                    continue;
                above[i / kFinePerCoarse] = std::max(above[i / kFinePerCoarse], here);
                box.include({i, j, k});
            }
        }
    return box;
}

}  // namespace

void Majorants::compute(const CellRanges& ranges, const TransferTables& tables, ivec3 volumeSize, const FlatMask& mask,
                        const FlatParts& parts) {
    const ivec3 size = ranges.fineSize(), coarseSize = ranges.coarseSize();
    fine.resize(ranges.cells().size());
    coarse.assign(std::size_t(coarseSize.x) * coarseSize.y * coarseSize.z, 0.0f);
    const std::vector<CurveBound> curves = curveBounds(tables.flat(), parts, ranges.whole());
    const auto tissueBound = [&](HuRange range, ivec3 cell) {
        if (parts.labels == nullptr)
            return curves[0].over(range);
        float most = 0;
        forCurvesIn(parts, volumeSize, size, cell,
                    [&](int curve) { most = std::max(most, curves[std::size_t(curve)].over(range)); });
        return most;
    };
    const auto boundIn = [&](HuRange range, ivec3 cell) {
        const float whole = tissueBound(range, cell);
        return whole > 0 && mask.voxels != nullptr ? maskedBound(whole, highestWeight(mask, volumeSize, cell)) : whole;
    };
    // Bound the fine and coarse cells, slab by slab in parallel.
    std::vector<Box> boxes(coarseSize.z);
    tbb::parallel_for(0, coarseSize.z, [&](int slab) { boxes[slab] = boundSlab(*this, ranges, slab, boundIn); });
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
