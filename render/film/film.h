#pragma once
/// The film: the mean and the variance of each pixel and channel of an image, or of a part of it, over any number of
/// samples. Parts of it may have more samples than others.
///   order      row by row from the top; pixel (x, y) of the film at y * width + x
///   tiles      in pixels of the image, of which the film holds area(); whole cells (tile_progress.h)
///   radiance   linear Rec. 709
/// Stays accurate for 1e7 iterations: blocks of 64 samples in double, merged by Chan's formula.

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

/// The estimate of one pixel.
struct PixelEstimate {
    dvec3 mean{0.0};
    /// Standard error of the mean, an upper bound from this pixel's samples alone (see localErrors()); 0 below 2
    /// samples.
    dvec3 standardError{0.0};
    dvec3 errorDraw{0.0};  ///< see errorDrawOf()
    std::uint64_t count = 0;
    HalfMeans halves;
    bool tissue = false;  ///< a sample met tissue
    bool unlit = false;   ///< no sample brought light, though one may: see isUnlit()
};

/// The content of a film, pixel by pixel, from which another film, on another device, can continue.
struct FilmContent {
    TileProgress progress;
    std::vector<Moments> moments;  ///< moments of all full blocks
    std::vector<PixelSums> block;  ///< sums of the running block
    Health health;
};

/// Returns whether both hold the same bits, number by number; padding between the numbers is ignored. Health is left
/// out.
bool sameBits(const FilmContent& a, const FilmContent& b);
bool sameBits(std::span<const PixelSums> a, std::span<const PixelSums> b);
bool sameBits(std::span<const Moments> a, std::span<const Moments> b);

/// Samples of a tile that were taken elsewhere, in one block or in whole blocks.
struct TileResult {
    std::uint64_t revision = 0;  ///< revision of the scene
    Tile tile;
    SampleRange samples;           ///< samples of one block that the sums hold, or those of several whole blocks
    std::vector<PixelSums> sums;   ///< row by row; of whole blocks: empty, with their `seen` bits
    Health health;                 ///< health of the samples that were never sent before
    std::vector<Moments> moments;  ///< moments of whole blocks and of all samples of the film before them
};

using PixelLook = std::function<void(std::size_t index, const Moments& known)>;

class Film {
  public:
    /// Creates an empty film; the first sample of each pixel gets the number `first`.
    Film(const Tile& area, std::uint64_t revision, std::uint64_t first = 0);
    /// Creates an empty film of a whole image.
    Film(ivec2 size, std::uint64_t revision) : Film(wholeImage(size), revision) {}
    /// Continues from `content`, which has as many pixels as its progress covers.
    Film(std::uint64_t revision, FilmContent content);

    const Tile& area() const { return progress_.area(); }
    ivec2 size() const { return {area().width, area().height}; }
    std::uint64_t revision() const { return revision_; }
    const TileProgress& progress() const { return progress_; }
    SampleCounts samples() const { return progress_.counts(); }
    /// Returns the number of samples that every pixel has.
    std::uint64_t samplesPerPixel() const { return samples().least; }

    /// Empties the film, for another scene. Allocates no memory where the film was as large before.
    void restart(const Tile& area, std::uint64_t revision);

    /// Returns the next samples of the whole area: at most `wanted`, never across a block's end. All pixels must
    /// have the same samples.
    SampleRange nextSamples(std::uint32_t wanted) const;
    /// Returns the running block's sums of the pixels in `tile`, and the image's health; a device adds to both.
    TileSums sums(const Tile& tile);
    /// Records that all pixels of `tile` have got the samples of `range`, their next ones; merges a block that is full.
    void commit(const Tile& tile, SampleRange range);
    void commit(SampleRange range) { commit(area(), range); }

    /// Merges sums that were computed elsewhere: `result.samples` begin where the tile's running block begins and reach
    /// further than the film's own sums, which they replace. So the order of the additions, and with it every bit, does
    /// not depend on where the sums were computed. Errors: the sums are of another scene (stale), of no whole cells of
    /// this film (foreign), here already (twice), behind a gap (early), or no sums; the film is then as before.
    /// The moments of whole blocks replace the film's in the same way.
    Result<void> merge(const TileResult& result);
    /// Returns the moments of all full blocks of the pixels in `tile`, row by row; nothing: there is no full block.
    std::vector<Moments> fullBlocks(const Tile& tile) const;

    PixelEstimate pixel(int x, int y) const;
    /// Returns the status without a display: displayError is not known.
    FilmStatus status() const;
    /// Returns the status on a display of that tone. On the way `look` is called for each pixel, on many threads, with
    /// its index and its moments.
    FilmStatus status(const Tone& tone, const PixelLook& look) const;
    FilmStatus status(const Tone& tone) const { return status(tone, area()); }
    /// Returns the status of the pixels of `tile` alone, a part of the film; its samples are those of the cells around
    /// it, its health that of the whole film.
    FilmStatus status(const Tone& tone, const Tile& tile) const;

    /// Returns the sample counts and the health; no errors are known.
    FilmStatus counts() const;
    /// Calls `look` for each pixel, as status() does.
    void each(const PixelLook& look) const;

    FilmContent content() const { return {progress_, moments_, block_, health_}; }

  private:
    /// Sums over the pixels of a tile; look(index, moments, a draw of the error, counts) adds to the counts.
    template <class Look>
    std::pair<StatusSums, ErrorCounts> survey(const Tile& tile, const Look& look) const;
    template <class Look>
    FilmStatus statusOn(const Tone& tone, const Tile& tile, const Look& look) const;
    Moments at(std::size_t index) const { return merged(moments_[index], block_[index]); }
    /// Returns the index of the pixel at the corner of `tile`.
    std::size_t indexOf(const Tile& tile) const {
        return std::size_t(tile.y - area().y) * std::size_t(area().width) + std::size_t(tile.x - area().x);
    }
    /// Returns the index of the pixel of `tile` that is number i there, row by row.
    std::size_t indexIn(const Tile& tile, std::size_t i) const {
        const std::size_t width = std::size_t(tile.width), stride = std::size_t(area().width);
        return indexOf(tile) + (width == stride ? i : i / width * stride + i % width);
    }
    Result<void> check(const TileResult& result) const;
    void replaceBlocks(const TileResult& result);

    TileProgress progress_;
    std::uint64_t revision_;
    std::vector<PixelSums> block_;
    std::vector<Moments> moments_;
    Health health_;
};

}  // namespace pdr
