#pragma once
/// The highest visibility weight of a mask in each fine cell (kernel/bounds/mask_bound.h), found when it is first asked
/// for and kept: to look through the mask takes most of the time of new bounds, and it stays while curves are edited.

#include <cstdint>
#include <vector>

#include "render/kernel/bounds/mask_bound.h"

namespace pdr {

class HighestWeights {
  public:
    /// There is no mask.
    HighestWeights() = default;
    /// `volume`: its size in voxels; `cells`: number of fine cells. What `mask` points to must outlive this.
    HighestWeights(const FlatMask& mask, ivec3 volume, ivec3 cells)
        : mask_(mask),
          volume_(volume),
          cells_(cells),
          known_(mask.voxels ? std::size_t(cells.x) * cells.y * cells.z : 0, kUnknown) {}

    bool hasMask() const { return mask_.voxels != nullptr; }
    /// Returns highestWeight() of a cell. One cell must not be asked for by two threads at once.
    int at(ivec3 cell) {
        std::int16_t& known = known_[(std::size_t(cell.z) * cells_.y + cell.y) * cells_.x + cell.x];
        if (known == kUnknown)
            known = std::int16_t(highestWeight(mask_, volume_, cell));
        return known;
    }

  private:
    static constexpr std::int16_t kUnknown = -1;

    FlatMask mask_{};
    ivec3 volume_{0}, cells_{0};
    std::vector<std::int16_t> known_;
};

}  // namespace pdr
