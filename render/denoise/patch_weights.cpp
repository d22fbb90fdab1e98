#include "render/denoise/patch_weights.h"

#include <algorithm>

namespace pdr::denoise {
namespace {

constexpr int kSearch = 5;         ///< radius of the window
constexpr float kFall = 0.7f;      ///< drop of the window's weight from its middle to its rim
constexpr float kStrength = 0.8f;  ///< standard deviations of the noise that are the unit of distance
constexpr float kCut = 4;          ///< distance from which on the weight is 0

/// Returns the weight of the search window, 0 outside of it. The window is round and fades: a square one leaves a
/// cross-hatch.
float windowWeight(ivec2 apart) {
    const float radius = kSearch + 0.5f, squared = float(apart.x * apart.x + apart.y * apart.y) / (radius * radius);
    return squared > 1 ? 0 : 1 - kFall * squared;
}

/// Returns the weight for a patch's mean distance. A polynomial: the same bits everywhere.
float likeness(float distance) {
    const float rest = std::max(0.0f, 1 - std::max(0.0f, distance) * (1 / kCut));
    return rest * rest * rest;
}

}  // namespace

PatchWeights::PatchWeights(const NoisyImage& image, int begin, int end)
    : luminance_(image.luminance),
      variance_(image.variance),
      begin_(begin),
      rows_(end - begin),
      width_(image.luminance.size().x),
      distances_(std::size_t(width_ + 2 * kReach)),
      likenesses_(std::size_t(width_ + 2 * kSpread)),
      across_(std::size_t(rows_ + 2 * kReach) * likenesses_.size()),
      shared_(std::size_t(rows_ + 2 * kSpread) * std::size_t(width_)) {
    static_assert(kSearch + kReach <= Plane::kBorder);
}

const std::vector<ivec2>& PatchWeights::neighbours() {
    static const std::vector<ivec2> all = [] {
        std::vector<ivec2> inside;
        for (int y = -kSearch; y <= kSearch; ++y)
            for (int x = -kSearch; x <= kSearch; ++x)
                if (windowWeight({x, y}) > 0)
                    inside.emplace_back(x, y);
        return inside;
    }();
    return all;
}

void PatchWeights::compare(ivec2 apart) {
    apart_ = apart;
    for (int y = -kReach; y < rows_ + kReach; ++y)
        measure(y);
    for (int y = -kSpread; y < rows_ + kSpread; ++y)
        weigh(y);
}

void PatchWeights::write(int y, float* __restrict weights) const {
    const float window = windowWeight(apart_);
    const float *upper = sharedRow(y - 1), *middle = sharedRow(y), *lower = sharedRow(y + 1);
    for (int x = 0; x < width_; ++x)
        weights[x] = window * ((upper[x] + middle[x]) + lower[x]);
}

float* PatchWeights::acrossRow(int y) {
    return &across_[std::size_t(y + kReach) * likenesses_.size()];
}

/// Computes the squared differences less what the noise explains, in units of the noise, summed over the columns of a
/// patch.
void PatchWeights::measure(int y) {
    const float *here = luminance_.row(begin_ + y) - kReach, *noiseHere = variance_.row(begin_ + y) - kReach;
    const float* there = luminance_.row(begin_ + y + apart_.y) - kReach + apart_.x;
    const float* noiseThere = variance_.row(begin_ + y + apart_.y) - kReach + apart_.x;
    float* __restrict distances = distances_.data();
    for (int x = 0; x < width_ + 2 * kReach; ++x) {
        const float difference = here[x] - there[x], noise = noiseHere[x] + noiseThere[x];
        distances[x] = (difference * difference - noise) / (kStrength * kStrength * noise);
    }
    const float* d = distances_.data();
    float* __restrict sums = acrossRow(y);
    for (int x = 0; x < width_ + 2 * kSpread; ++x)
        sums[x] = ((d[x] + d[x + 1]) + (d[x + 2] + d[x + 3])) + d[x + 4];
}

/// Computes the weights of one row, summed over the columns that share them.
void PatchWeights::weigh(int y) {
    const int wide = width_ + 2 * kSpread;
    const float* s = acrossRow(y - kPatch);
    float* __restrict likenesses = likenesses_.data();
    for (int x = 0; x < wide; ++x) {
        const float sum = ((s[x] + s[x + wide]) + (s[x + 2 * wide] + s[x + 3 * wide])) + s[x + 4 * wide];
        likenesses[x] = likeness(sum * (1.0f / 25));
    }
    const float* l = likenesses_.data();
    float* __restrict sums = sharedRow(y);
    for (int x = 0; x < width_; ++x)
        sums[x] = (l[x] + l[x + 1]) + l[x + 2];
}

}  // namespace pdr::denoise
