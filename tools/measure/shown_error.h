#pragma once
/// How far an image on the screen is from another, in levels of 255.

#include <QImage>
#include <algorithm>
#include <cmath>
#include <vector>

#include "render/film/film.h"

namespace pdr {

/// Levels that 95 % of the tissue are off: of each pixel the channel that is off most. `tissue` says which pixels.
inline int levelsOff(const QImage& image, const QImage& truth, const Film& tissue) {
    std::vector<int> levels;
    for (int y = 0; y < truth.height(); ++y)
        for (int x = 0; x < truth.width(); ++x) {
            if (!tissue.pixel(x, y).tissue)
                continue;
            const QRgb a = image.pixel(x, y), b = truth.pixel(x, y);
            levels.push_back(std::max(
                {std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))}));
        }
    if (levels.empty())
        return 0;
    const auto at = levels.begin() + std::ptrdiff_t(0.95 * double(levels.size() - 1));
    std::ranges::nth_element(levels, at);
    return *at;
}

/// Mean, over tiles of 16 x 16 pixels and the channels, of how far the mean level of `a` is from that of `b`.
inline double tilesApart(const QImage& a, const QImage& b) {
    constexpr int kTile = 16;
    double apart = 0;
    for (int top = 0; top + kTile <= a.height(); top += kTile)
        for (int left = 0; left + kTile <= a.width(); left += kTile) {
            int sums[3] = {};
            for (int y = top; y < top + kTile; ++y)
                for (int x = left; x < left + kTile; ++x) {
                    const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
                    sums[0] += qRed(p) - qRed(q);
                    sums[1] += qGreen(p) - qGreen(q);
                    sums[2] += qBlue(p) - qBlue(q);
                }
            apart += double(std::abs(sums[0]) + std::abs(sums[1]) + std::abs(sums[2])) / (3.0 * kTile * kTile);
        }
    return apart / std::max(double(a.width() / kTile) * (a.height() / kTile), 1.0);
}

/// Error of the change that `image` shows, over tiles as above, in parts of the change from `old` to `truth`: 1 is that
/// of the old image left as it is.
inline double changeError(const QImage& image, const QImage& old, const QImage& truth) {
    return tilesApart(image, truth) / std::max(tilesApart(old, truth), 1e-9);
}

}  // namespace pdr
