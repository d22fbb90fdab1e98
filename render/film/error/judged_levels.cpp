#include "render/film/error/judged_levels.h"

#include <array>

#include "render/base/significance.h"

namespace pdr {
namespace {

constexpr int kQuantiles = 8;  ///< quantiles of the distance of a normal number from 0
constexpr int kOfOnePixel = 2;

/// Returns the distances [standard deviations] in the middle of eight equally likely ranges.
const std::array<float, kQuantiles>& distances() {
    static const auto all = [] {
        std::array<float, kQuantiles> z{};
        for (int i = 0; i < kQuantiles; ++i)
            z[std::size_t(i)] = float(normalZ((i + 0.5) / kQuantiles));
        return z;
    }();
    return all;
}

/// Returns the slope of channel c of the tone curve [levels per unit of the exposure] between one deviation of that
/// channel below and above.
float slopeAround(const DisplayTransform& transform, vec3 light, int c, float deviation) {
    vec3 low = light, high = light;
    low[c] = glm::max(light[c] - deviation, 0.0f);
    high[c] = glm::max(light[c] + deviation, low[c] + 0x1p-14f);
    return (transform.exactLevels(high)[c] - transform.exactLevels(low)[c]) / (high[c] - low[c]);
}

}  // namespace

void JudgedLevels::add(ivec2 pixel, vec3 light, vec3 variance, vec3 squaredErrors, float correlation) {
    const vec3 shown = light * perExposure_, deviation = glm::sqrt(variance) * perExposure_;
    // Neighbours take turns, so that all quantiles come up in any 8 x 8 pixels
    for (int i = 0; i < kOfOnePixel; ++i) {
        const int turn = (pixel.x + 3 * pixel.y + i * kQuantiles / kOfOnePixel) & (kQuantiles - 1);
        const float z = distances()[std::size_t(turn)];
        for (const float off : {-z, z})
            ++counts_.pixels[errorBinOf(levelsApart(transform_, shown, off * deviation, correlation))];
    }
    for (int c = 0; c < 3; ++c) {
        const double slope = double(slopeAround(transform_, shown, c, deviation[c]) * perExposure_);
        tile_[c] += slope * slope * double(squaredErrors[c] - variance[c]);
        variances_[c] += slope * slope * double(variance[c]);
    }
    isInTile_ = true;
}

void JudgedLevels::endTile() {
    squares_ += tile_ * tile_;
    tiles_ += isInTile_;
    isInTile_ = false;
    tile_ = dvec3(0);
}

void JudgedLevels::add(const JudgedLevels& other) {
    counts_.add(other.counts_);
    variances_ += other.variances_;
    squares_ += other.squares_;
    tiles_ += other.tiles_;
}

double JudgedLevels::uncertainty(int fitted) const {
    int worst = 0;
    for (int c = 1; c < 3; ++c)
        worst = variances_[c] > variances_[worst] ? c : worst;
    const double free = std::sqrt(tiles_ / (tiles_ - fitted));
    return variances_[worst] > 0 ? free * std::sqrt(squares_[worst]) / variances_[worst] : 0;
}

}  // namespace pdr
