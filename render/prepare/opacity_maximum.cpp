#include "render/prepare/opacity_maximum.h"

#include <algorithm>
#include <bit>

namespace pdr {

OpacityMaximum::OpacityMaximum(const FlatTransferFunction& function, HuRange domain) : first_(domain.lowest) {
    const int bins = std::max(int(domain.highest) - domain.lowest, 0);
    points_.resize(bins + 1);
    std::vector<float> bin(bins);
    const auto whole = [this](int i) { return std::int16_t(first_ + i); };
    for (int i = 0; i <= bins; ++i)
        points_[i] = highestOpacity(function, {whole(i), whole(i)});
    for (int i = 0; i < bins; ++i)
        bin[i] = highestOpacity(function, {whole(i), whole(i + 1)});
    levels_.push_back(std::move(bin));
    for (int width = 1; 2 * width <= bins; width *= 2) {
        const std::vector<float>& below = levels_.back();
        std::vector<float> level(bins - 2 * width + 1);
        for (std::size_t i = 0; i < level.size(); ++i)
            level[i] = std::max(below[i], below[i + width]);
        levels_.push_back(std::move(level));
    }
}

float OpacityMaximum::over(HuRange range) const {
    if (range.lowest > range.highest)
        return 0;
    const unsigned from = unsigned(int(range.lowest) - first_);
    const unsigned bins = unsigned(int(range.highest) - range.lowest);
    if (bins == 0)
        return points_[from];
    const int level = std::bit_width(bins) - 1;
    const std::vector<float>& maxima = levels_[level];
    return std::max(maxima[from], maxima[from + bins - (1u << level)]);
}

}  // namespace pdr
