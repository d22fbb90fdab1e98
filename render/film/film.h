#pragma once
/// What has been learned about the image: mean and variance per pixel and channel, over any number of samples.
///   order   row by row from the top; pixel (x, y) at y * width + x        radiance   linear Rec. 709
/// Stays right for 1e7 iterations: blocks of 64 samples in double, merged by Chan's formula.

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "render/base/portable.h"
#include "render/base/tile.h"
#include "render/film/status_sums.h"

namespace pdr {

/// One pixel, as far as it is known.
struct PixelEstimate {
    dvec3 mean{0.0};
    dvec3 standardError{0.0};  ///< of the mean; 0 below 2 samples
    std::uint64_t count = 0;
    bool tissue = false;  ///< a sample met some
};

/// All that a film knows, pixel by pixel: what another film, on another device, goes on from.
struct FilmContent {
    std::uint64_t samplesPerPixel = 0;
    std::vector<Moments> moments;  ///< of all full blocks
    std::vector<PixelSums> block;  ///< of the running one
    Health health;
};

/// Whether both know the same to the last bit, number by number: what lies between the numbers in memory is nobody's
/// value. Health is left out.
bool sameBits(const FilmContent& a, const FilmContent& b);

using PixelLook = std::function<void(std::size_t index, const Moments& known)>;

class Film {
  public:
    Film(ivec2 size, std::uint64_t revision);
    /// `content` of size.x * size.y pixels.
    Film(ivec2 size, std::uint64_t revision, FilmContent content);

    ivec2 size() const { return size_; }
    std::uint64_t revision() const { return revision_; }
    std::uint64_t samplesPerPixel() const { return samples_; }

    /// The next samples to take: at most `wanted`, never across a block's end.
    SampleRange nextSamples(std::uint32_t wanted) const;
    /// The running block's sums of the pixels in `tile`, and the image's health; a device adds to both.
    TileSums sums(const Tile& tile);
    /// Tells that all pixels have got the samples of `range`; merges the block when it is full.
    void commit(SampleRange range);

    PixelEstimate pixel(int x, int y) const;
    /// Without a display: its displayError is not known.
    FilmStatus status() const;
    /// On a display of that exposure, with a look at each pixel on the way: `look` gets its index and what is known of
    /// it, on many threads.
    FilmStatus status(double exposure, const PixelLook& look) const;

    FilmContent content() const { return {samples_, moments_, block_, health_}; }

  private:
    /// Sums over all pixels; look(index, what is known, its standard error, counts) adds to the counts.
    template <class Look>
    std::pair<StatusSums, ErrorCounts> survey(const Look& look) const;
    Moments at(std::size_t index) const { return merged(moments_[index], block_[index]); }

    ivec2 size_;
    std::uint64_t revision_;
    std::uint64_t samples_ = 0;
    std::vector<PixelSums> block_;
    std::vector<Moments> moments_;
    Health health_;
};

}  // namespace pdr
