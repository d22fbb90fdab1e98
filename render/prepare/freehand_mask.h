#pragma once
/// What lines drawn by hand leave of a volume, as a mask: made anew from the lines, which alone are kept in files.

#include <memory>
#include <vector>

#include "render/scene/clip.h"
#include "render/volume/mask.h"

namespace pdr {

/// Seen is what no line cuts away; the line runs along the middle of an even edge of Mask::kEdgeMm. Null: there is no
/// line.
std::shared_ptr<const Mask> freehandMask(const std::vector<FreehandCut>& cuts, const VolumeGeometry& geometry);

/// All that hides parts of a volume, and what is seen of it: made again only where something of it is another.
class SeenParts {
  public:
    SeenParts() = default;
    /// `visible`: what is seen but for the lines; null: all. `last`: where there may be something to use again, or
    /// null.
    SeenParts(const std::vector<FreehandCut>& cuts, std::shared_ptr<const Mask> visible, const VolumeGeometry& geometry,
              const SeenParts* last);

    /// Null: everything is seen.
    const std::shared_ptr<const Mask>& mask() const { return mask_; }

  private:
    std::vector<FreehandCut> cuts_;
    VolumeGeometry geometry_;
    std::shared_ptr<const Mask> visible_, left_;  ///< by the lines
    std::shared_ptr<const Mask> mask_;
};

}  // namespace pdr
