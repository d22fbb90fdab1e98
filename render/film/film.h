#pragma once
/// What has been learned about an image, or about a part of it: mean and variance per pixel and channel, over any
/// number of samples. Parts of it may be further than others.
///   order      row by row from the top; pixel (x, y) of the film at y * width + x
///   tiles      in pixels of the image, of which the film holds area(); whole cells (tile_progress.h)
///   radiance   linear Rec. 709
/// Stays right for 1e7 iterations: blocks of 64 samples in double, merged by Chan's formula.

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "render/base/result.h"
#include "render/base/tile.h"
#include "render/film/status_sums.h"
#include "render/film/tile_progress.h"

namespace pdr {

/// One pixel, as far as it is known.
struct PixelEstimate {
    dvec3 mean{0.0};
    dvec3 standardError{0.0};  ///< of the mean, at most, as the pixel knows it (see localErrors()); 0 below 2 samples
    dvec3 errorDraw{0.0};      ///< see errorDrawOf()
    std::uint64_t count = 0;
    HalfMeans halves;
    bool tissue = false;  ///< a sample met some
    bool unlit = false;   ///< no sample brought light, though one may: see isUnlit()
};

/// All that a film knows, pixel by pixel: what another film, on another device, goes on from.
struct FilmContent {
    TileProgress progress;
    std::vector<Moments> moments;  ///< of all full blocks
    std::vector<PixelSums> block;  ///< of the running one
    Health health;
};

/// Whether both know the same to the last bit, number by number: what lies between the numbers in memory is nobody's
/// value. Health is left out.
bool sameBits(const FilmContent& a, const FilmContent& b);
bool sameBits(std::span<const PixelSums> a, std::span<const PixelSums> b);

/// Sums of a tile that were made elsewhere.
struct TileResult {
    std::uint64_t revision = 0;  ///< of the scene
    Tile tile;
    SampleRange samples;          ///< of which the sums are, all of them; in one block
    std::vector<PixelSums> sums;  ///< row by row
    Health health;                ///< of those samples that were never sent before
};

using PixelLook = std::function<void(std::size_t index, const Moments& known)>;

class Film {
  public:
    /// Empty; the first sample of each pixel is to have the number `first`.
    Film(const Tile& area, std::uint64_t revision, std::uint64_t first = 0);
    /// Of a whole image.
    Film(ivec2 size, std::uint64_t revision) : Film(wholeImage(size), revision) {}
    /// `content` of as many pixels as its progress speaks of.
    Film(std::uint64_t revision, FilmContent content);

    const Tile& area() const { return progress_.area(); }
    ivec2 size() const { return {area().width, area().height}; }
    std::uint64_t revision() const { return revision_; }
    const TileProgress& progress() const { return progress_; }
    SampleCounts samples() const { return progress_.counts(); }
    /// That every pixel has.
    std::uint64_t samplesPerPixel() const { return samples().least; }

    /// Empties it, for another scene. No memory is taken where it was as large before.
    void restart(const Tile& area, std::uint64_t revision);

    /// The next samples of the whole area: at most `wanted`, never across a block's end. All of it must be equally far.
    SampleRange nextSamples(std::uint32_t wanted) const;
    /// The running block's sums of the pixels in `tile`, and the image's health; a device adds to both.
    TileSums sums(const Tile& tile);
    /// Tells that all pixels of `tile` have got the samples of `range`, their next ones; merges a block that is full.
    void commit(const Tile& tile, SampleRange range);
    void commit(SampleRange range) { commit(area(), range); }

    /// Takes sums that were made elsewhere: `result.samples` begin where the tile's running block begins and reach
    /// further than what is here, whose place they take. So the order of the additions is the same wherever they were
    /// made, and so are the bits. Errors: they are of another scene (stale), of no whole cells of this film (foreign),
    /// here already (twice), behind a gap (early), or no sums; the film is as before then.
    Result<void> merge(const TileResult& result);

    PixelEstimate pixel(int x, int y) const;
    /// Without a display: its displayError is not known.
    FilmStatus status() const;
    /// On a display of that exposure, with a look at each pixel on the way: `look` gets its index and what is known of
    /// it, on many threads.
    FilmStatus status(double exposure, const PixelLook& look) const;
    FilmStatus status(double exposure) const { return status(exposure, area()); }
    /// Of the pixels of `tile` alone, a part of the film; its samples are those of the cells around it, its health that
    /// of the whole film.
    FilmStatus status(double exposure, const Tile& tile) const;

    /// Samples and health; no errors are known.
    FilmStatus counts() const;
    /// The look alone.
    void each(const PixelLook& look) const;

    FilmContent content() const { return {progress_, moments_, block_, health_}; }

  private:
    /// Sums over the pixels of a tile; look(index, what is known, a draw of its error, counts) adds to the counts.
    template <class Look>
    std::pair<StatusSums, ErrorCounts> survey(const Tile& tile, const Look& look) const;
    template <class Look>
    FilmStatus statusOn(double exposure, const Tile& tile, const Look& look) const;
    Moments at(std::size_t index) const { return merged(moments_[index], block_[index]); }
    /// Of the pixel at the corner of `tile`.
    std::size_t indexOf(const Tile& tile) const {
        return std::size_t(tile.y - area().y) * std::size_t(area().width) + std::size_t(tile.x - area().x);
    }
    /// Of the pixel of `tile` that is number i there, row by row.
    std::size_t indexIn(const Tile& tile, std::size_t i) const {
        const std::size_t width = std::size_t(tile.width), stride = std::size_t(area().width);
        return indexOf(tile) + (width == stride ? i : i / width * stride + i % width);
    }
    Result<void> check(const TileResult& result) const;

    TileProgress progress_;
    std::uint64_t revision_;
    std::vector<PixelSums> block_;
    std::vector<Moments> moments_;
    Health health_;
};

}  // namespace pdr
