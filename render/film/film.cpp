#include "render/film/film.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace pdr {
namespace {

bool sameBits(const dvec3& a, const dvec3& b) {
    const auto same = [](double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); };
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

bool sameBits(const Moments& a, const Moments& b) {
    return a.count == b.count && sameBits(a.mean, b.mean) && sameBits(a.m2, b.m2);
}

bool sameBits(const PixelSums& a, const PixelSums& b) {
    return a.count == b.count && a.seen == b.seen && sameBits(a.sum, b.sum) && sameBits(a.sumOfSquares, b.sumOfSquares);
}

template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return sameBits(x, y); });
}

}  // namespace

bool sameBits(const FilmContent& a, const FilmContent& b) {
    return a.samplesPerPixel == b.samplesPerPixel && sameBits(a.moments, b.moments) && sameBits(a.block, b.block);
}

Film::Film(ivec2 size, std::uint64_t revision)
    : size_(size), revision_(revision), block_(std::size_t(size.x) * size.y), moments_(block_.size()) {}

Film::Film(ivec2 size, std::uint64_t revision, FilmContent content)
    : size_(size),
      revision_(revision),
      samples_(content.samplesPerPixel),
      block_(std::move(content.block)),
      moments_(std::move(content.moments)),
      health_(content.health) {}

SampleRange Film::nextSamples(std::uint32_t wanted) const {
    const std::uint32_t room = kSamplesPerBlock - std::uint32_t(samples_ % kSamplesPerBlock);
    return {samples_, std::min(wanted, room)};
}

TileSums Film::sums(const Tile& tile) {
    return {block_.data() + std::size_t(tile.y) * size_.x + tile.x, size_.x, &health_};
}

void Film::commit(SampleRange range) {
    samples_ = range.first + range.count;
    if (samples_ % kSamplesPerBlock != 0)
        return;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, block_.size(), 4096), [&](const auto& pixels) {
        for (std::size_t i = pixels.begin(); i != pixels.end(); ++i) {
            moments_[i] = merged(moments_[i], block_[i]);
            block_[i] = nextBlock(block_[i]);
        }
    });
}

PixelEstimate Film::pixel(int x, int y) const {
    const Moments moments = at(std::size_t(y) * size_.x + x);
    return {moments.mean, standardErrorOf(moments), moments.count,
            (block_[std::size_t(y) * size_.x + x].seen & kSeenTissue) != 0};
}

template <class Look>
std::pair<StatusSums, ErrorCounts> Film::survey(const Look& look) const {
    using Pixels = tbb::blocked_range<std::size_t>;
    using Sums = std::pair<StatusSums, ErrorCounts>;
    const auto add = [&](const Pixels& pixels, Sums sums) {
        for (std::size_t i = pixels.begin(); i != pixels.end(); ++i) {
            const Moments known = at(i);
            const dvec3 standardError = standardErrorOf(known);
            sums.first.add(known, standardError, block_[i].seen);
            look(i, known, standardError, sums.second);
        }
        return sums;
    };
    const auto join = [](Sums a, const Sums& b) {
        a.first.add(b.first);
        a.second.add(b.second);
        return a;
    };
    // Deterministic: the sums must not depend on how many threads there are.
    return tbb::parallel_deterministic_reduce(Pixels(0, moments_.size(), 16384), Sums{}, add, join);
}

FilmStatus Film::status() const {
    const StatusSums sums = survey([](auto&&...) {}).first;
    return statusOf(sums, moments_.size(), samples_, health_);
}

FilmStatus Film::status(double exposure, const PixelLook& look) const {
    const float* curve = displayCurve();
    const auto [sums, errors] =
        survey([&](std::size_t pixel, const Moments& known, dvec3 standardError, ErrorCounts& counts) {
            if (knowsItsError(known, block_[pixel].seen))
                ++counts.pixels[errorBinOf(levelsOff(curve, known.mean, standardError, exposure))];
            look(pixel, known);
        });
    return statusOf(sums, moments_.size(), samples_, health_, {errors, exposure});
}

}  // namespace pdr
