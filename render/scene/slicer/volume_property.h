#pragma once
/// What 3D Slicer says of a volume's look, and how it becomes a look of ours. Its opacity is that of a unit distance,
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
    double unitDistanceMm = 1;                            ///< of the opacity; > 0
    double anisotropy = 0;                                ///< of scattering; [-1, 1]
    Curve opacity;                                        ///< of a unit distance; [0, 1]
    std::vector<ColourStop> colours;                      ///< sRGB, each channel in [0, 1]
    bool simplified = false;  ///< the file says more: opacity by gradient, or curves that are not straight
};

/// `property` in the light and at the brightness of `base`. Between two points an opacity stands for a bent extinction,
/// which gets points of its own. What is simplified, the look says. Errors: no points, points that do not ascend,
/// values out of range.
Result<NamedLook> lookOf(const VolumeProperty& property, const std::string& name, const NamedLook& base);

/// The other way round. What Slicer does not know is lost: lights, cut, model, emission.
VolumeProperty propertyOf(const NamedLook& look);

}  // namespace pdr::slicer
