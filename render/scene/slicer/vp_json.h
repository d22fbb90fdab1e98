#pragma once
/// 3D Slicer's JSON format of volume properties, `.vp.json`. Source: volume-property-schema-v1.0.0.json in 3D Slicer's
/// repository.

#include <string>
#include <string_view>

#include "render/scene/slicer/volume_property.h"

namespace pdr::slicer {

/// Reads the first component of the first property. `where` is used in error texts, beside the field's path.
Result<VolumeProperty> propertyFromJson(std::string_view text, std::string_view where);
std::string jsonOf(const VolumeProperty& property);

}  // namespace pdr::slicer
