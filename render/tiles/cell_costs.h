#pragma once
/// Relative rendering cost of each cell of an image, learned from the times of leases: background costs a sixth of
/// tissue.
///   cost   pixels times samples, weighted by the cost of the cell relative to the mean of the area

#include <cstdint>
#include <vector>

#include "render/base/tile.h"
#include "render/tiles/lease.h"

namespace pdr {

/// A finished lease.
struct TimedLease {
    WorkerId worker = kOwnDevice;
    Tile tile;  ///< whole cells of the area
    std::uint32_t samples = 0;
    double seconds = 0;
};

class CellCosts {
  public:
    /// Makes costs for an empty area: all pixels cost the same.
    CellCosts() = default;
    explicit CellCosts(const Tile& area);
    /// Returns these costs stretched over another area, for an image that has changed its size.
    CellCosts stretchedOver(const Tile& area) const;

    const Tile& area() const { return area_; }
    /// Whether costs have been learned.
    bool isKnown() const { return isKnown_; }
    /// Returns the cost of one sample of each pixel of `tile`, which consists of whole cells of the area.
    double ofSample(const Tile& tile) const;

    /// Learns from the leases of one request. All leases of a worker together give its speed; the excess time of one
    /// lease is attributed to its cells (multiplicative algebraic reconstruction, Gordon, Bender & Herman 1970: later
    /// requests are tiled differently, which separates the cells).
    void learn(const std::vector<TimedLease>& leases);

  private:
    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(columns_) + std::size_t(x); }
    double before(int x, int y) const { return before_[std::size_t(y) * std::size_t(columns_ + 1) + std::size_t(x)]; }
    Tile cellsOf(const Tile& tile) const;
    int pixelsOf(int x, int y) const;
    void sum();

    Tile area_;
    int columns_ = 0, rows_ = 0;
    std::vector<double> density_;  ///< cost of a pixel of each cell, row by row; mean over the area: 1
    std::vector<double> before_;   ///< summed-area table: cost of all cells above and left, (columns + 1) x (rows + 1)
    bool isKnown_ = false;
};

}  // namespace pdr
