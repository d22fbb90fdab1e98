#include "app/document/part_masks.h"

#include <algorithm>
#include <utility>

namespace pdr::app {

void PartMasks::add(const Visible& visible, std::shared_ptr<const Mask> mask) {
    constexpr std::size_t kMost = 4;
    known_.push_back({visible, std::move(mask)});
    if (known_.size() > kMost)
        known_.pop_front();
}

void PartMasks::show(const Visible& visible) {
    const auto known = std::ranges::find(known_, visible, &PartMask::visible);
    if (visible.all())
        shown_ = {};
    else if (known != known_.end())
        shown_ = *known;
}

}  // namespace pdr::app
