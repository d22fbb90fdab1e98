#pragma once
/// The progress of each part of an image: the number of the sample that comes next, cell by cell.

#include <cstdint>
#include <vector>

#include "render/base/portable.h"
#include "render/base/tile.h"

namespace pdr {

/// Edge of a cell in pixels. All pixels of a cell have the same samples. Cells are counted from the corner of the area;
/// its right and lower edges cut some.
inline constexpr int kFilmCell = 16;

/// Returns the number of cells along that many pixels; the last one may be cut.
constexpr int cellsIn(int pixels) {
    return (pixels + kFilmCell - 1) / kFilmCell;
}

/// Least, most and mean number of samples per pixel.
struct SampleCounts {
    std::uint64_t least = 0, most = 0;
    double mean = 0;
    bool operator==(const SampleCounts&) const = default;
};

/// A tile whose pixels all have the same samples.
struct EvenTile {
    Tile tile;
    std::uint64_t next = 0;  ///< number of the pixels' next sample
    bool operator==(const EvenTile&) const = default;
};

class TileProgress {
  public:
    TileProgress() = default;
    /// Covers the part `area` of an image; the first sample of each pixel gets the number `first`.
    explicit TileProgress(const Tile& area, std::uint64_t first = 0);

    const Tile& area() const { return area_; }
    std::uint64_t first() const { return first_; }
    /// Returns the smallest whole cells around `region`, which is inside the area.
    Tile cellsAround(const Tile& region) const;
    /// Returns whether `tile` consists of whole cells of the area.
    bool isWholeCells(const Tile& tile) const { return isInside(tile, area_) && cellsAround(tile) == tile; }
    /// Divides the whole cells `cells` into few disjoint tiles of pixels that have the same samples.
    std::vector<EvenTile> evenTiles(const Tile& cells) const;
    /// Records that the pixels of the whole cells `cells` have all samples before `next`.
    void advance(const Tile& cells, std::uint64_t next);

    /// Returns the sample counts of the pixels of the cells around `part`.
    SampleCounts counts(const Tile& part) const;
    SampleCounts counts() const { return counts(area_); }

    bool operator==(const TileProgress&) const = default;

  private:
    /// Returns a tile of pixels in units of cells.
    Tile cellsOf(const Tile& pixels) const;
    Tile pixelsOf(const Tile& cells) const;
    std::uint64_t& at(int x, int y) { return next_[std::size_t(y) * columns_ + x]; }
    std::uint64_t at(int x, int y) const { return next_[std::size_t(y) * columns_ + x]; }

    Tile area_;
    std::uint64_t first_ = 0;
    int columns_ = 0;
    std::vector<std::uint64_t> next_;  ///< next sample number of each cell, row by row
};

}  // namespace pdr
