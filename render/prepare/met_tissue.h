#pragma once
/// What of a transfer function a volume can meet: the pieces of the curve between its lowest and its highest HU. Only
/// what is met can show, whatever else the curve says.

#include <algorithm>
#include <vector>

#include "render/prepare/transfer_tables.h"
#include "render/scene/transfer_function.h"
#include "render/volume/volume.h"

namespace pdr {

class MetTissue {
  public:
    /// `function` must have passed its check().
    MetTissue(const TransferFunction& function, const Volume& volume);

    /// Whether some of it is opaque. Where it is not, no light meets anything.
    bool any() const { return extinctionPerMm_ > 0 && highestOpacity_ > 0; }
    /// No point of the volume is more opaque; 0 to 1.
    float highestOpacity() const { return highestOpacity_; }
    /// No point has a higher extinction [1/mm].
    double highestExtinction() const { return double(extinctionPerMm_) * highestOpacity_; }
    /// No gradient in the volume is steeper [HU/mm]; each axis is counted for itself, so it may be up to sqrt(3) less.
    double steepest() const { return steepest_; }

    /// Whether property(material) is anything but black in opaque tissue that is met.
    template <class Property>
    bool anywhere(Property property) const {
        return any() && std::ranges::any_of(materials_, [&](const Material& m) { return property(m) != vec3(0); });
    }

  private:
    std::vector<Material> materials_;  ///< at the ends of the opaque pieces
    float extinctionPerMm_ = 0;
    float highestOpacity_ = 0;
    double steepest_ = 0;
};

}  // namespace pdr
