#include "render/film/film.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace pdr {
namespace {

bool sameBits(const dvec3& a, const dvec3& b) {
    const auto same = [](double x, double y) {
        return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    };
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

bool sameBits(const vec3& a, const vec3& b) {
    return sameBits(dvec3(a), dvec3(b));
}

bool sameBits(const Moments& a, const Moments& b) {
    return a.count == b.count && a.evenCount == b.evenCount && sameBits(a.mean, b.mean) && sameBits(a.m2, b.m2) &&
           sameBits(a.evenMean, b.evenMean);
}

bool sameBits(const PixelSums& a, const PixelSums& b) {
    return a.count == b.count && a.evenCount == b.evenCount && a.seen == b.seen && sameBits(a.sum, b.sum) &&
           sameBits(a.sumOfSquares, b.sumOfSquares) && sameBits(a.evenSum, b.evenSum);
}

template <class T>
bool allSameBits(std::span<const T> a, std::span<const T> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return sameBits(x, y); });
}

/// Returns whether these are sums of at most `count` samples that are radiances.
bool areSums(const PixelSums& sums, std::uint32_t count) {
    const auto are = [](const auto& sum) {
        const double total = double(sum.x) + double(sum.y) + double(sum.z);
        return sum.x >= 0 && sum.y >= 0 && sum.z >= 0 && std::isfinite(total);
    };
    return sums.count <= count && sums.evenCount <= sums.count && are(sums.sum) && are(sums.sumOfSquares) &&
           are(sums.evenSum);
}

/// Returns whether these are moments of at most `count` samples that are radiances.
bool areMoments(const Moments& moments, std::uint64_t count) {
    const auto are = [](const auto& of) {
        return of.x >= 0 && of.y >= 0 && of.z >= 0 && std::isfinite(double(of.x) + double(of.y) + double(of.z));
    };
    return moments.count <= count && moments.evenCount <= moments.count && are(moments.mean) && are(moments.m2) &&
           are(moments.evenMean);
}

template <class Each>
void eachPixel(std::size_t pixels, const Each& each) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pixels, 4096), [&](const auto& some) {
        for (std::size_t i = some.begin(); i != some.end(); ++i)
            each(i);
    });
}

}  // namespace

bool sameBits(const FilmContent& a, const FilmContent& b) {
    return a.progress == b.progress && allSameBits<Moments>(a.moments, b.moments) &&
           allSameBits<PixelSums>(a.block, b.block);
}

bool sameBits(std::span<const PixelSums> a, std::span<const PixelSums> b) {
    return allSameBits(a, b);
}

bool sameBits(std::span<const Moments> a, std::span<const Moments> b) {
    return allSameBits(a, b);
}

Film::Film(const Tile& area, std::uint64_t revision, std::uint64_t first)
    : progress_(area, first), revision_(revision), block_(pixelCount(area)), moments_(block_.size()) {}

Film::Film(std::uint64_t revision, FilmContent content)
    : progress_(std::move(content.progress)),
      revision_(revision),
      block_(std::move(content.block)),
      moments_(std::move(content.moments)),
      health_(content.health) {}

void Film::restart(const Tile& area, std::uint64_t revision) {
    progress_ = TileProgress(area);
    revision_ = revision;
    health_ = {};
    const std::size_t pixels = pixelCount(area);
    block_.resize(pixels);
    moments_.resize(pixels);
    eachPixel(pixels, [&](std::size_t i) {
        block_[i] = {};
        moments_[i] = {};
    });
}

SampleRange Film::nextSamples(std::uint32_t wanted) const {
    assert(samples().least == samples().most);
    return samplesInBlock(progress_.first() + samples().least, wanted);
}

TileSums Film::sums(const Tile& tile) {
    return {block_.data() + indexOf(tile), area().width, &health_};
}

void Film::commit(const Tile& tile, SampleRange range) {
    assert(progress_.isWholeCells(tile));
    progress_.advance(tile, range.end());
    if (range.end() % kSamplesPerBlock != 0)
        return;
    eachPixel(pixelCount(tile), [&](std::size_t i) {
        const std::size_t pixel = indexIn(tile, i);
        moments_[pixel] = merged(moments_[pixel], block_[pixel]);
        block_[pixel] = nextBlock(block_[pixel]);
    });
}

Result<void> Film::check(const TileResult& result) const {
    const auto refused = [&](const Text& why) {
        const Tile& tile = result.tile;
        return Error{phrase("a tile's result was refused: %1", why),
                     std::to_string(tile.width) + " x " + std::to_string(tile.height) + " pixels at (" +
                         std::to_string(tile.x) + ", " + std::to_string(tile.y) + "), " +
                         std::to_string(result.samples.count) + " samples from number " +
                         std::to_string(result.samples.first),
                     phrase("Leave it; the tile is rendered again.")};
    };
    // Check the scene and the tile
    if (result.revision != revision_)
        return refused(phrase("it is of another scene"));
    const std::size_t pixels =
        std::size_t(std::max(result.tile.width, 0)) * std::size_t(std::max(result.tile.height, 0));
    if (pixels == 0 || !progress_.isWholeCells(result.tile) || result.sums.size() != pixels)
        return refused(phrase("no such tile is asked for"));
    // Check that the samples continue the tile's running block
    const std::vector<EvenTile> here = progress_.evenTiles(result.tile);
    const std::uint64_t next = here.front().next, block = next - next % kSamplesPerBlock;
    const SampleRange& samples = result.samples;
    if (here.size() == 1 && samples.end() <= next)
        return refused(phrase("its samples are there already"));
    const bool isWhole = !result.moments.empty();
    const bool ends =
        isWhole ? samples.end() % kSamplesPerBlock == 0 : samples == samplesInBlock(samples.first, samples.count);
    if (here.size() != 1 || samples.first != std::max(block, progress_.first()) || !ends)
        return refused(phrase("its samples are not the next ones"));
    // Check the numbers
    const std::uint64_t all = samples.end() - progress_.first();
    const auto isEstimate = [&](const Moments& moments) { return areMoments(moments, all); };
    const auto isSum = [&](const PixelSums& sums) { return areSums(sums, isWhole ? 0 : samples.count); };
    if ((isWhole && result.moments.size() != pixels) || !std::ranges::all_of(result.sums, isSum) ||
        !std::ranges::all_of(result.moments, isEstimate))
        return refused(phrase("its sums are none"));
    return {};
}

std::vector<Moments> Film::fullBlocks(const Tile& tile) const {
    std::vector<Moments> moments;
    const std::uint64_t next = progress_.evenTiles(tile).front().next;
    if (next / kSamplesPerBlock == progress_.first() / kSamplesPerBlock)
        return moments;
    moments.reserve(pixelCount(tile));
    for (std::size_t i = 0; i < pixelCount(tile); ++i)
        moments.push_back(moments_[indexIn(tile, i)]);
    return moments;
}

void Film::replaceBlocks(const TileResult& result) {
    for (std::size_t i = 0; i < result.moments.size(); ++i) {
        const std::size_t pixel = indexIn(result.tile, i);
        moments_[pixel] = result.moments[i];
        block_[pixel] = {.seen = block_[pixel].seen | result.sums[i].seen};
    }
    progress_.advance(result.tile, result.samples.end());
}

Result<void> Film::merge(const TileResult& result) {
    if (Result<void> fits = check(result); !fits)
        return fits;
    health_.add(result.health);
    if (!result.moments.empty()) {
        replaceBlocks(result);
        return {};
    }
    const Tile& tile = result.tile;
    const TileSums here = sums(tile);
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
            PixelSums& pixel = here.pixels[std::ptrdiff_t(y) * here.stride + x];
            const std::uint32_t seen = pixel.seen;
            pixel = result.sums[std::size_t(y) * std::size_t(tile.width) + std::size_t(x)];
            pixel.seen |= seen;
        }
    commit(tile, result.samples);
    return {};
}

PixelEstimate Film::pixel(int x, int y) const {
    const std::size_t index = std::size_t(y) * std::size_t(area().width) + std::size_t(x);
    const Moments moments = at(index);
    const std::uint32_t seen = block_[index].seen;
    return {moments.mean,      standardErrorOf(moments),  errorDrawOf(moments),  moments.count,
            halvesOf(moments), (seen & kSeenTissue) != 0, isUnlit(moments, seen)};
}

template <class Look>
std::pair<StatusSums, ErrorCounts> Film::survey(const Tile& tile, const Look& look) const {
    using Pixels = tbb::blocked_range<std::size_t>;
    using Sums = std::pair<StatusSums, ErrorCounts>;
    const auto add = [&](const Pixels& pixels, Sums sums) {
        for (std::size_t i = pixels.begin(); i != pixels.end(); ++i) {
            const std::size_t pixel = indexIn(tile, i);
            const Moments known = at(pixel);
            const dvec3 draw = errorDrawOf(known);
            sums.first.add(known, draw, block_[pixel].seen);
            look(pixel, known, draw, sums.second);
        }
        return sums;
    };
    const auto join = [](Sums a, const Sums& b) {
        a.first.add(b.first);
        a.second.add(b.second);
        return a;
    };
    // A deterministic reduction: the sums must not depend on the number of threads.
    return tbb::parallel_deterministic_reduce(Pixels(0, pixelCount(tile), 16384), Sums{}, add, join);
}

FilmStatus Film::counts() const {
    const SampleCounts samples = this->samples();
    return {.samplesPerPixel = samples.least,
            .meanSamplesPerPixel = samples.mean,
            .mostSamplesPerPixel = samples.most,
            .health = health_,
            .relativeError = std::numeric_limits<double>::infinity()};
}

void Film::each(const PixelLook& look) const {
    eachPixel(moments_.size(), [&](std::size_t pixel) { look(pixel, at(pixel)); });
}

FilmStatus Film::status() const {
    const StatusSums sums = survey(area(), [](auto&&...) {}).first;
    return statusOf(sums, moments_.size(), samples(), health_);
}

template <class Look>
FilmStatus Film::statusOn(const Tone& tone, const Tile& tile, const Look& look) const {
    const DisplayTransform transform = displayTransform(tone);
    const auto [sums, errors] =
        survey(tile, [&](std::size_t pixel, const Moments& known, dvec3 draw, ErrorCounts& counts) {
            if (knowsItsError(known, block_[pixel].seen))
                ++counts.pixels[errorBinOf(levelsOff(transform, known.mean, draw))];
            look(pixel, known);
        });
    return statusOf(sums, pixelCount(tile), progress_.counts(tile), health_, {errors, transform.exposure});
}

FilmStatus Film::status(const Tone& tone, const PixelLook& look) const {
    return statusOn(tone, area(), look);
}

FilmStatus Film::status(const Tone& tone, const Tile& tile) const {
    return statusOn(tone, tile, [](auto&&...) {});
}

}  // namespace pdr
