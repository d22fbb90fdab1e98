#pragma once
/// How far each part of an image is: the number of the sample that comes next, cell by cell.

#include <cstdint>
#include <vector>

#include "render/base/portable.h"
#include "render/base/tile.h"

namespace pdr {

/// Pixels along the edges of a cell, all of which have the same samples. Cells are counted from the corner of the area;
/// its right and lower edges cut some.
inline constexpr int kFilmCell = 16;

/// Cells along that many pixels; the last one may be cut.
constexpr int cellsIn(int pixels) {
    return (pixels + kFilmCell - 1) / kFilmCell;
}

/// Samples per pixel.
struct SampleCounts {
    std::uint64_t least = 0, most = 0;
    double mean = 0;
    bool operator==(const SampleCounts&) const = default;
};

/// Pixels that are equally far.
struct EvenTile {
    Tile tile;
    std::uint64_t next = 0;  ///< number of their next sample
    bool operator==(const EvenTile&) const = default;
};

class TileProgress {
  public:
    TileProgress() = default;
    /// Of the part `area` of an image; the first sample of each pixel is to have the number `first`.
    explicit TileProgress(const Tile& area, std::uint64_t first = 0);

    const Tile& area() const { return area_; }
    std::uint64_t first() const { return first_; }
    /// The smallest whole cells around `region`, which is inside the area.
    Tile cellsAround(const Tile& region) const;
    /// Whether `tile` consists of whole cells of the area.
    bool isWholeCells(const Tile& tile) const { return isInside(tile, area_) && cellsAround(tile) == tile; }
    /// The whole cells `cells`, cut into few disjoint tiles of pixels that are equally far.
    std::vector<EvenTile> evenTiles(const Tile& cells) const;
    /// The pixels of the whole cells `cells` have got all samples before `next`.
    void advance(const Tile& cells, std::uint64_t next);

    /// Samples that the pixels of the cells around `part` have.
    SampleCounts counts(const Tile& part) const;
    SampleCounts counts() const { return counts(area_); }

    bool operator==(const TileProgress&) const = default;

  private:
    /// In cells.
    Tile cellsOf(const Tile& pixels) const;
    Tile pixelsOf(const Tile& cells) const;
    std::uint64_t& at(int x, int y) { return next_[std::size_t(y) * columns_ + x]; }
    std::uint64_t at(int x, int y) const { return next_[std::size_t(y) * columns_ + x]; }

    Tile area_;
    std::uint64_t first_ = 0;
    int columns_ = 0;
    std::vector<std::uint64_t> next_;  ///< of each cell, row by row
};

}  // namespace pdr
