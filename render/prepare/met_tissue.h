#pragma once
/// Visible tissue: the pieces of the curves between the lowest and the highest HU of a volume. Only
/// these can affect the image, whatever else the curve contains.

#include <algorithm>
#include <vector>

#include "render/prepare/transfer_tables.h"
#include "render/scene/scene.h"

namespace pdr {

class MetTissue {
  public:
    /// Finds the visible tissue of a scene with a volume, in all its parts. `scene` must have passed its check().
    explicit MetTissue(const Scene& scene);

    /// Returns whether some of the tissue is opaque. If none is, no light meets anything.
    bool any() const { return highestExtinction_ > 0; }
    /// Returns the highest opacity of any point of the volume, 0 to 1.
    float highestOpacity() const { return highestOpacity_; }
    /// Returns the highest extinction of any point [1/mm].
    double highestExtinction() const { return highestExtinction_; }
    /// Returns a bound on the gradients in the volume [HU/mm]. Each axis is counted separately, so the bound may be too
    /// high by a factor of up to sqrt(3).
    double steepest() const { return steepest_; }

    /// Returns whether property(material) is anything but black in visible, opaque tissue.
    template <class Property>
    bool anywhere(Property property) const {
        return any() && std::ranges::any_of(materials_, [&](const Material& m) { return property(m) != vec3(0); });
    }

  private:
    void add(const TransferFunction& function, HuRange range);

    std::vector<Material> materials_;  ///< at the ends of the opaque pieces
    double highestExtinction_ = 0;
    float highestOpacity_ = 0;
    double steepest_ = 0;
};

}  // namespace pdr
