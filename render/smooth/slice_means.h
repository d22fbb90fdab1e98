#pragma once
/// Non-local means of one slice (Buades, Coll & Morel 2005): every pixel becomes the mean of those around it, weighted
/// by how alike the patches around both look. Each pair of pixels is compared once and counts for both.
///
/// It runs on float, one pixel at a time, and on FloatLanes, kLanes at a time; both do the same arithmetic in the same
/// order, so that they give the same bits.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "render/base/lanes.h"

namespace pdr {

/// The means of slices of one size, one slice after the other in the same memory.
template <class Real>
class SliceMeans {
  public:
    static constexpr int kSearch = 3;  ///< largest distance of two compared pixels along an axis
    static constexpr int kPatch = 1;   ///< pixels of a patch on each side of its centre

    /// `size`: pixels of a slice, each >= 1. `noise`: standard deviation of a pixel, > 0.
    SliceMeans(ivec2 size, float noise);

    /// Writes the means of `slice` to `out`; x fastest, then y. Pixels beyond an edge mirror those before it.
    void write(std::span<const std::int16_t> slice, std::span<std::int16_t> out);

  private:
    static constexpr int kStep = sizeof(Real) / sizeof(float);  ///< pixels at a time
    /// Pixels beside a row: those that are compared with pixels of the slice, with their patches, and whole lanes.
    static constexpr int kLeft = 2 * kSearch + kPatch + 1, kRight = kLeft + kLanes;
    static constexpr int kAround = kSearch + kPatch;  ///< rows above and below
    static constexpr int kBand = 16;                  ///< rows that are compared with all neighbours while in the cache

    float* row(std::vector<float>& plane, int y) { return &plane[std::size_t(y + kAround) * stride_ + kLeft]; }
    template <class Body>
    void along(int first, int end, Body body) {
        for (int x = first; x < end; x += kStep)
            body(x);
    }

    void read(std::span<const std::int16_t> slice);
    void compareBand(int begin, int end, ivec2 apart);
    void writeSquares(int y, ivec2 apart);
    void addPairs(int y, ivec2 apart);

    ivec2 size_;
    std::size_t stride_;
    float perSquare_;  ///< how fast a weight falls with the sum of a patch's squared differences
    std::vector<float> values_, sums_, weights_;       ///< planes of the slice and its margins
    std::array<std::vector<float>, 3> squares_;        ///< squared differences of three rows
    std::vector<float> columns_, pairs_, difference_;  ///< numbers of one row
};

/// Returns the index in [0, count) that stands for `index`, mirrored at the outermost ones.
inline int mirrored(int index, int count) {
    if (count == 1)
        return 0;
    const int period = 2 * (count - 1), inside = std::abs(index) % period;
    return std::min(inside, period - inside);
}

template <class Real>
SliceMeans<Real>::SliceMeans(ivec2 size, float noise)
    : size_(size), stride_(std::size_t(kLeft + size.x + kRight)), perSquare_(1 / (288 * noise * noise)) {
    for (std::vector<float>* plane : {&values_, &sums_, &weights_})
        plane->resize(stride_ * std::size_t(size.y + 2 * kAround));
    for (std::vector<float>* line : {&squares_[0], &squares_[1], &squares_[2], &columns_, &pairs_, &difference_})
        line->resize(stride_);
}

template <class Real>
void SliceMeans<Real>::write(std::span<const std::int16_t> slice, std::span<std::int16_t> out) {
    read(slice);
    std::ranges::fill(sums_, 0.0f);
    std::ranges::fill(weights_, 1.0f);  // a pixel's own
    for (int begin = -kSearch; begin < size_.y; begin += kBand)
        for (int dy = 0; dy <= kSearch; ++dy)
            for (int dx = dy ? -kSearch : 1; dx <= kSearch; ++dx)
                compareBand(begin, std::min(begin + kBand, size_.y), {dx, dy});
    for (int y = 0; y < size_.y; ++y) {
        const float *values = row(values_, y), *sums = row(sums_, y), *weights = row(weights_, y);
        std::int16_t* to = &out[std::size_t(y) * std::size_t(size_.x)];
        for (int x = 0; x < size_.x; ++x)  // rounded to the nearest; above 0 that is what truncation does
            to[x] = std::int16_t(int(values[x] + sums[x] / weights[x] + 32768.5f) - 32768);
    }
}

template <class Real>
void SliceMeans<Real>::read(std::span<const std::int16_t> slice) {
    for (int y = -kAround; y < size_.y + kAround; ++y) {
        const std::int16_t* from = &slice[std::size_t(mirrored(y, size_.y)) * std::size_t(size_.x)];
        float* to = row(values_, y);
        for (int x = 0; x < size_.x; ++x)
            to[x] = from[x];
        for (int x = -kLeft; x < 0; ++x)
            to[x] = from[mirrored(x, size_.x)];
        for (int x = size_.x; x < size_.x + kRight; ++x)
            to[x] = from[mirrored(x, size_.x)];
    }
}

/// Compares the pixels of some rows with those that lie `apart`.
template <class Real>
void SliceMeans<Real>::compareBand(int begin, int end, ivec2 apart) {
    writeSquares(begin - 1, apart);
    writeSquares(begin, apart);
    for (int y = begin; y < end; ++y) {
        writeSquares(y + 1, apart);
        addPairs(y, apart);
    }
}

template <class Real>
void SliceMeans<Real>::writeSquares(int y, ivec2 apart) {
    const float *own = row(values_, y), *other = row(values_, y + apart.y) + apart.x;
    float* squares = &squares_[std::size_t(y + kAround) % 3][kLeft];
    along(-kSearch - kPatch, size_.x + kSearch + kPatch, [=](int x) {
        const Real difference = load<Real>(other + x) - load<Real>(own + x);
        store<Real>(difference * difference, squares + x);
    });
}

/// The weight of a pair whose patches differ by the mean square d is 1 up to what noise s alone makes of it, 2 s^2, and
/// falls from there like exp(-(d - 2 s^2) / h^2), h = 2 s; in its place (1 - x / 8)^8, which ends.
template <class Real>
void SliceMeans<Real>::addPairs(int y, ivec2 apart) {
    const auto squares = [&](int at) { return &squares_[std::size_t(at + kAround) % 3][kLeft]; };
    const float *above = squares(y - 1), *here = squares(y), *below = squares(y + 1);
    float *columns = &columns_[kLeft], *pairs = &pairs_[kLeft], *differences = &difference_[kLeft];
    along(-kSearch - kPatch, size_.x + kSearch + kPatch, [=](int x) {
        store<Real>(load<Real>(above + x) + load<Real>(here + x) + load<Real>(below + x), columns + x);
    });
    const float *own = row(values_, y), *other = row(values_, y + apart.y) + apart.x;
    float *sums = row(sums_, y), *weights = row(weights_, y);
    const float perSquare = perSquare_;
    along(-kSearch, size_.x + kSearch, [=](int x) {
        const Real patch = load<Real>(columns + x - 1) + load<Real>(columns + x) + load<Real>(columns + x + 1);
        const Real falling = max(Real{} + 0.0f, min(Real{} + 1.0f, 1.0625f - patch * perSquare));
        const Real second = falling * falling, fourth = second * second, weight = fourth * fourth;
        const Real difference = weight * (load<Real>(other + x) - load<Real>(own + x));
        store<Real>(weight, pairs + x);
        store<Real>(difference, differences + x);
        store<Real>(load<Real>(sums + x) + difference, sums + x);
        store<Real>(load<Real>(weights + x) + weight, weights + x);
    });
    float *otherSums = row(sums_, y + apart.y) + apart.x, *otherWeights = row(weights_, y + apart.y) + apart.x;
    along(-kSearch, size_.x + kSearch, [=](int x) {
        store<Real>(load<Real>(otherSums + x) - load<Real>(differences + x), otherSums + x);
        store<Real>(load<Real>(otherWeights + x) + load<Real>(pairs + x), otherWeights + x);
    });
}

}  // namespace pdr
