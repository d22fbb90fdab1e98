#include "render/prepare/edited_majorants.h"

#include <atomic>
#include <utility>

#include "render/prepare/bound_cells.h"

namespace pdr {
namespace {

/// Returns the range of HU whose bounds have changed between the same numbers of curves.
HuRange changedRange(const std::vector<CurveBound>& before, const std::vector<CurveBound>& after) {
    HuRange changed = kEmptyRange;
    for (std::size_t i = 0; i < after.size(); ++i)
        changed.include(after[i].changedFrom(before[i]));
    return changed;
}

}  // namespace

/// Finds the weights of the scene's mask, unless they are known.
void EditedMajorants::useMaskOf(const PreparedScene& prepared) {
    if (mask_ == prepared.mask)
        return;
    mask_ = prepared.mask;
    weights_ = {prepared.flat.mask, prepared.volume->size(), prepared.ranges->fineSize()};
    newest_.isStale = spare_.isStale = true;
}

std::shared_ptr<const Majorants> EditedMajorants::of(const PreparedScene& prepared) {
    useMaskOf(prepared);
    std::vector<CurveBound> curves =
        curveBounds(prepared.flat.transferFunction, prepared.flat.parts, prepared.ranges->whole());
    const BoundedTissue tissue{*prepared.ranges, prepared.volume->size(), weights_, prepared.flat.parts, curves};
    std::swap(newest_, spare_);
    if (!newest_.majorants || newest_.majorants.use_count() > 1)
        newest_ = {std::make_shared<Majorants>(), {}, nullptr};
    std::atomic_thread_fence(std::memory_order_acquire);  // another thread may have let go of it
    const bool isEdit =
        !newest_.isStale && newest_.curves.size() == curves.size() && newest_.cells == prepared.parts.cells;
    if (isEdit && coarse_.empty())
        coarse_ = coarseRanges(*prepared.ranges);
    if (isEdit)
        boundChanged(*newest_.majorants, tissue, coarse_, changedRange(newest_.curves, curves));
    else
        boundAll(*newest_.majorants, tissue);
    newest_.curves = std::move(curves);
    newest_.cells = prepared.parts.cells;
    newest_.isStale = false;
    return newest_.majorants;
}

}  // namespace pdr
