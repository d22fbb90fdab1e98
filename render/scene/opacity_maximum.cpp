#include "render/scene/opacity_maximum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace pdr {

namespace {

/// The curve's opacity; inside a piece that is not 0 throughout, never 0, however close to its end.
float opacityOrTrace(const TransferFunction& function, float hu) {
    const float value = function.opacityAt(hu);
    if (value > 0)
        return value;
    const std::vector<TransferNode>& nodes = function.nodes;
    const auto after = std::ranges::upper_bound(nodes, hu, {}, &TransferNode::hu);
    if (after == nodes.begin() || after == nodes.end() || (after - 1)->hu == hu)
        return value;
    return std::max((after - 1)->opacity, after->opacity) * std::numeric_limits<float>::epsilon();
}

}  // namespace

OpacityMaximum::OpacityMaximum(const TransferFunction& function, HuRange domain) : first_(domain.lowest) {
    const int bins = std::max(int(domain.highest) - domain.lowest, 0);
    points_.resize(bins + 1);
    for (int i = 0; i <= bins; ++i)
        points_[i] = opacityOrTrace(function, float(first_ + i));

    // A linear piece has its maximum at an end, so the ends of a bin and the nodes inside it suffice.
    std::vector<float> bin(bins);
    for (int i = 0; i < bins; ++i)
        bin[i] = std::max({function.opacityAt(float(first_ + i) - kHuSlack), points_[i], points_[i + 1],
                           function.opacityAt(float(first_ + i + 1) + kHuSlack)});
    for (const TransferNode& node : function.nodes) {
        // A node on a bin's border belongs to both neighbours; both sides of a step are nodes.
        const int last = int(std::floor(node.hu + kHuSlack)) - first_;
        const int from = int(std::floor(node.hu - kHuSlack)) - first_;
        for (int i = std::max(from, 0); i <= std::min(last, bins - 1); ++i)
            bin[i] = std::max(bin[i], node.opacity);
    }
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
