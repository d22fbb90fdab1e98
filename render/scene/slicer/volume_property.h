#pragma once
/// A volume property of 3D Slicer, and its conversion to and from a look. Slicer's opacity is that of a unit distance,
/// ours is extinction; its colours are those of a screen, ours are linear.

#include <string>
#include <vector>

#include "render/scene/edit/curve.h"
#include "render/scene/edit/tissue_channels.h"
#include "render/scene/named_look.h"

namespace pdr::slicer {

struct VolumeProperty {
    bool shade = true;
    double ambient = 0.1, diffuse = 0.9, specular = 0.2;  ///< [0, 1]
    double specularPower = 10;                            ///< >= 0
    double unitDistanceMm = 1;                            ///< distance that `opacity` refers to; > 0
    double anisotropy = 0;                                ///< anisotropy of scattering; [-1, 1]
    Curve opacity;                                        ///< opacity of a unit distance; [0, 1]
    std::vector<ColourStop> colours;                      ///< sRGB, each channel in [0, 1]
    bool simplified = false;  ///< whether the file holds more: opacity by gradient, or curves that are not straight
};

/// Converts `property` to a look with the light and brightness of `base`. Between two points, a straight opacity curve
/// stands for a bent extinction curve, which gets additional points. The look's `doesNotShow` says what is simplified.
/// Errors: no points, points that do not ascend, values out of range.
Result<NamedLook> lookOf(const VolumeProperty& property, const std::string& name, const NamedLook& base);

/// Converts a look to a volume property. What Slicer cannot represent is lost: lights, cut, model, emission.
VolumeProperty propertyOf(const NamedLook& look);

}  // namespace pdr::slicer
