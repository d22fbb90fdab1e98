#include "render/prepare/opacity_maximum.h"

#include <algorithm>

namespace pdr {

OpacityMaximum::OpacityMaximum(const FlatTransferFunction& function, HuRange domain) : first_(domain.lowest) {
    const int bins = std::max(int(domain.highest) - domain.lowest, 0);
    stride_ = bins + 1;
    maxima_.resize(std::size_t(2) * stride_);
    const auto whole = [this](int i) { return std::int16_t(first_ + i); };
    for (int i = 0; i <= bins; ++i)
        maxima_[i] = highestOpacity(function, {whole(i), whole(i)});
    for (int i = 0; i < bins; ++i)
        maxima_[stride_ + i] = highestOpacity(function, {whole(i), whole(i + 1)});
    for (int width = 1; 2 * width <= bins; width *= 2) {
        const std::size_t below = maxima_.size() - std::size_t(stride_);
        maxima_.resize(maxima_.size() + std::size_t(stride_));
        for (int i = 0; i <= bins - 2 * width; ++i)
            maxima_[below + stride_ + i] = std::max(maxima_[below + i], maxima_[below + i + width]);
    }
    for (int i = 0; i <= bins; ++i)
        if (maxima_[i] > 0)
            seen_.include({whole(i), whole(i)});
    for (int i = 0; i < bins; ++i)
        if (maxima_[stride_ + i] > 0)
            seen_.include({whole(i), whole(i + 1)});
}

HuRange OpacityMaximum::changedFrom(const OpacityMaximum& before) const {
    HuRange changed = kEmptyRange;
    for (int i = 0; i < stride_; ++i) {
        const auto hu = std::int16_t(first_ + i);
        if (maxima_[i] != before.maxima_[i])
            changed.include({hu, hu});
        if (maxima_[stride_ + i] != before.maxima_[stride_ + i])  // that after the last one is 0 in both
            changed.include({hu, std::int16_t(hu + 1)});
    }
    return changed;
}

}  // namespace pdr
