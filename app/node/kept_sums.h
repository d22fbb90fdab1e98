#pragma once
/// The sums and moments that a node has sent last, cell by cell: when it goes on with a cell they need not be sent
/// back. The coordinator remembers in the same way who has which (render/tiles/kept_cells.h), and compares hashes.

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "render/tiles/kept_cells.h"

namespace pdr::node {

class KeptSums {
  public:
    /// Keeps what the result has, beside what is known of the samples before. Forgets everything else where it would be
    /// too much.
    void keep(const LeaseResult& result);
    /// Fills in the sums or moments that the lease continues. False: they are not all here.
    bool fill(Lease& lease) const;
    void clear();

    static constexpr std::uint64_t kMostPixels = 1 << 21;  ///< 150 MB: those of an image of 1920 x 1080

  private:
    struct Cell {
        Tile tile;
        KnownSamples known;
        std::vector<PixelSums> sums;      ///< sums of the running block
        std::vector<Moments> moments;     ///< moments of the blocks before it
        std::vector<std::uint32_t> seen;  ///< PixelSums::seen of all of these
    };

    static void take(Cell& cell, const LeaseResult& result);

    std::map<std::pair<int, int>, Cell> cells_;  ///< by the x and y of each cell's corner
    std::uint64_t pixels_ = 0;
};

}  // namespace pdr::node
