#pragma once
/// The majorants of scenes that follow one another. They take the memory of those before the last, once no scene needs
/// it: to clear new memory takes longer than to compute them. Where that holds bounds of the same voxels, mask and
/// parts, only cells that hold HU whose opacity has changed since are bounded anew.

#include <memory>
#include <vector>

#include "render/prepare/curve_bound.h"
#include "render/prepare/prepared_scene.h"

namespace pdr {

class EditedMajorants {
  public:
    /// Returns the majorants of a scene, which needs all but these and its depths, and whose volume is the same as long
    /// as this exists.
    std::shared_ptr<const Majorants> of(const PreparedScene& prepared);

  private:
    /// Majorants, and what they were computed from.
    struct Bounded {
        std::shared_ptr<Majorants> majorants;
        std::vector<CurveBound> curves;
        std::shared_ptr<const CellCurves> cells;  ///< see PartTables
        bool isStale = false;                     ///< computed under another mask
    };

    void useMaskOf(const PreparedScene& prepared);

    Bounded newest_, spare_;
    std::shared_ptr<const Mask> mask_;  ///< mask of weights_; null: none
    HighestWeights weights_;
    HugePageVector<HuRange> coarse_;  ///< see coarseRanges(); empty before they are needed
};

}  // namespace pdr
