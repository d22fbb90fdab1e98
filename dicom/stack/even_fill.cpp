#include "dicom/stack/even_fill.h"

#include <algorithm>
#include <cmath>

namespace pdr::dicom {

namespace {

std::vector<double> gapsOf(const std::vector<double>& heights) {
    std::vector<double> gaps;
    for (std::size_t k = 1; k < heights.size(); ++k)
        gaps.push_back(heights[k] - heights[k - 1]);
    std::ranges::sort(gaps);
    return gaps;
}

/// Returns the slice at `height`, of which `above` is the first measured slice that lies higher, or the last.
SliceBlend blendAt(const std::vector<double>& heights, int above, double height, double sameMm) {
    const int below = above - 1;
    const double low = heights[std::size_t(below)], high = heights[std::size_t(above)];
    if (height - low <= sameMm)
        return {below, below, 0};
    if (high - height <= sameMm)
        return {above, above, 0};
    return {below, above, (height - low) / (high - low)};
}

/// Returns the runs of new slices that lie between measured ones far apart, each from the slice before it to the one
/// behind it.
std::vector<HoleHeights> holesIn(const EvenFill& fill, const std::vector<double>& heights) {
    std::vector<HoleHeights> holes;
    bool open = false;
    for (std::size_t k = 0; k < fill.slices.size(); ++k) {
        const SliceBlend& slice = fill.slices[k];
        const double apart = heights[std::size_t(slice.above)] - heights[std::size_t(slice.below)];
        const bool inHole = slice.weight > 0 && apart >= kHoleGaps * fill.gapMm;
        if (inHole && !open)
            holes.push_back({fill.gapMm * double(k - 1), 0});
        if (inHole)
            holes.back().toMm = fill.gapMm * double(k + 1);
        open = inHole;
    }
    return holes;
}

}  // namespace

std::optional<EvenFill> evenFill(const std::vector<double>& heights, double sameMm) {
    const std::vector<double> gaps = gapsOf(heights);
    const double usual = gaps[gaps.size() / 2], widest = gaps.back();
    if (widest > kWidestHoleMm || widest > kWidestHoleGaps * usual)
        return std::nullopt;
    // Choose the number of slices, so that the first and the last are measured ones
    const double length = heights.back() - heights.front();
    const double closest = std::max(gaps.front(), kLeastFillMm);
    const int most = kMostFill * int(heights.size());
    const int count = std::clamp(int(std::lround(length / closest)) + 1, 2, most);
    // Find the measured slices on both sides of each
    EvenFill fill{length / (count - 1), {}, 0, gaps.front(), widest, {}};
    int above = 1;
    for (int k = 0; k < count; ++k) {
        const double height = heights.front() + fill.gapMm * k;
        while (above + 1 < int(heights.size()) && heights[std::size_t(above)] < height)
            ++above;
        fill.slices.push_back(blendAt(heights, above, height, sameMm));
        const double off = std::min(std::abs(height - heights[std::size_t(above - 1)]),
                                    std::abs(heights[std::size_t(above)] - height));
        fill.furthestMm = std::max(fill.furthestMm, off);
    }
    fill.holes = holesIn(fill, heights);
    return fill;
}

}  // namespace pdr::dicom
