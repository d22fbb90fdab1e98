#pragma once
/// 3D Slicer's older text format of a volume property, `.vp`: one line each for interpolation, shade, diffuse, ambient,
/// specular and power, then opacity, opacity by gradient and colour as the number of values and the values themselves.
/// Source: 3D Slicer's developer guide, "Format of Volume Property (.vp) file".

#include <string>
#include <string_view>

#include "render/scene/slicer/volume_property.h"

namespace pdr::slicer {

/// Reads a volume property from its text; `where` is used in error texts, beside the line's name.
Result<VolumeProperty> propertyFromText(std::string_view text, std::string_view where);
std::string textOf(const VolumeProperty& property);

}  // namespace pdr::slicer
