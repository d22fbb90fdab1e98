#pragma once
/// The mask of freehand cuts: the parts of a volume that drawn lines leave visible. It is computed from the lines,
/// since files store only these.

#include <memory>
#include <vector>

#include "render/scene/clip.h"
#include "render/volume/mask.h"

namespace pdr {

/// Returns the mask of what no line cuts away; null if there is no line. The line runs along the middle of a uniform
/// edge of Mask::kEdgeMm.
std::shared_ptr<const Mask> freehandMask(const std::vector<FreehandCut>& cuts, const VolumeGeometry& geometry);

/// Everything that hides parts of a volume, and the resulting mask. Masks are computed again only where their inputs
/// change.
class SeenParts {
  public:
    SeenParts() = default;
    /// Combines the lines with `visible`, the mask of what is visible without them; null: everything. `last`: the parts
    /// of the scene before, whose masks may be reused, or null.
    SeenParts(const std::vector<FreehandCut>& cuts, std::shared_ptr<const Mask> visible, const VolumeGeometry& geometry,
              const SeenParts* last);

    /// Returns the mask; null if everything is visible.
    const std::shared_ptr<const Mask>& mask() const { return mask_; }

  private:
    std::vector<FreehandCut> cuts_;
    VolumeGeometry geometry_;
    std::shared_ptr<const Mask> visible_, left_;  ///< visible without the lines, left by the lines; null: everything
    std::shared_ptr<const Mask> mask_;            ///< both combined; null: everything
};

}  // namespace pdr
