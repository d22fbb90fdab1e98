#pragma once
/// What the parts of a picture cost, cell by cell, as it was found by rendering them: background costs a sixth of what
/// tissue does.
///   cost   pixels times samples, each worth what it costs against the mean of the area

#include <cstdint>
#include <vector>

#include "render/base/tile.h"
#include "render/tiles/lease.h"

namespace pdr {

/// A lease that somebody has done.
struct TimedLease {
    WorkerId worker = kOwnDevice;
    Tile tile;  ///< whole cells of the area
    std::uint32_t samples = 0;
    double seconds = 0;
};

class CellCosts {
  public:
    /// Of no area: all pixels cost the same.
    CellCosts() = default;
    explicit CellCosts(const Tile& area);
    /// Of another area, where a picture of another size lies: what was found is stretched over it.
    CellCosts stretchedOver(const Tile& area) const;

    const Tile& area() const { return area_; }
    /// Something was learned of it.
    bool isKnown() const { return isKnown_; }
    /// Of one sample of each pixel. `tile`: whole cells of the area.
    double ofSample(const Tile& tile) const;

    /// Learns from leases of one order. How fast each worker was is seen in all of its leases together; what one of
    /// them took longer than that is put down to its cells (multiplicative algebraic reconstruction, Gordon, Bender &
    /// Herman 1970: tiles of later orders lie otherwise, and so cells are told apart).
    void learn(const std::vector<TimedLease>& leases);

  private:
    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(columns_) + std::size_t(x); }
    double before(int x, int y) const { return before_[std::size_t(y) * std::size_t(columns_ + 1) + std::size_t(x)]; }
    Tile cellsOf(const Tile& tile) const;
    int pixelsOf(int x, int y) const;
    void sum();

    Tile area_;
    int columns_ = 0, rows_ = 0;
    std::vector<double> density_;  ///< of a pixel of each cell, row by row; mean over the area: 1
    std::vector<double> before_;   ///< summed-area table: cost of all cells above and left, (columns + 1) x (rows + 1)
    bool isKnown_ = false;
};

}  // namespace pdr
