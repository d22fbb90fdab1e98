#include "render/film/film.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pdr {

namespace {

/// What a status is made from, over some pixels.
struct Totals {
    double luminance = 0, squaredErrors = 0;
};

/// a * b + c, rounded once.
dvec3 fused(dvec3 a, dvec3 b, dvec3 c) {
    return {std::fma(a.x, b.x, c.x), std::fma(a.y, b.y, c.y), std::fma(a.z, b.z, c.z)};
}

}  // namespace

Film::Film(ivec2 size, std::uint64_t revision)
    : size_(size), revision_(revision), block_(std::size_t(size.x) * size.y), moments_(block_.size()) {}

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
            block_[i] = {};
        }
    });
}

/// Chan, Golub & LeVeque 1979: the moments of two sets from the moments of each.
Film::Moments Film::merged(const Moments& moments, const PixelSums& block) {
    Moments result = moments;
    if (block.count == 0)
        return result;
    const double n = block.count;
    const dvec3 blockMean = block.sum / n;
    // Of a large value with little noise nearly all of this cancels: rounded once, not twice.
    const dvec3 blockM2 = glm::max(fused(-block.sum, blockMean, block.sumOfSquares), dvec3(0.0));
    const double total = double(moments.count) + n;
    const dvec3 delta = blockMean - moments.mean;
    result.mean += delta * (n / total);
    result.m2 += blockM2 + delta * delta * (double(moments.count) * n / total);
    result.count += block.count;
    return result;
}

dvec3 Film::standardErrorOf(const Moments& moments) {
    if (moments.count < 2)
        return dvec3(0.0);
    return glm::sqrt(moments.m2 / (double(moments.count) * double(moments.count - 1)));
}

Film::Moments Film::at(std::size_t index) const {
    return merged(moments_[index], block_[index]);
}

PixelEstimate Film::pixel(int x, int y) const {
    const Moments moments = at(std::size_t(y) * size_.x + x);
    return {moments.mean, standardErrorOf(moments), moments.count};
}

FilmStatus Film::status() const {
    using Pixels = tbb::blocked_range<std::size_t>;
    const auto add = [this](const Pixels& pixels, Totals totals) {
        for (std::size_t i = pixels.begin(); i != pixels.end(); ++i) {
            const Moments moments = at(i);
            const double error = luminance(standardErrorOf(moments));
            totals.luminance += luminance(moments.mean);
            totals.squaredErrors += error * error;
        }
        return totals;
    };
    const auto join = [](const Totals& a, const Totals& b) {
        return Totals{a.luminance + b.luminance, a.squaredErrors + b.squaredErrors};
    };
    // Deterministic: the sums must not depend on how many threads there are.
    const Totals totals = tbb::parallel_deterministic_reduce(Pixels(0, moments_.size(), 16384), Totals{}, add, join);

    FilmStatus status{.samplesPerPixel = samples_, .health = health_};
    const double pixels = double(moments_.size());
    status.meanLuminance = totals.luminance / pixels;
    const double error = std::sqrt(totals.squaredErrors / pixels);
    if (samples_ < 2)
        status.relativeError = std::numeric_limits<double>::infinity();
    else if (error > 0)
        status.relativeError = error / status.meanLuminance;
    return status;
}

}  // namespace pdr
