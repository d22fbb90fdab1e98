#pragma once
/// The names of the parts that rules find as label maps (part_rules.h).

#include <string>
#include <string_view>

#include "render/base/text.h"

namespace pdr::segment {

inline constexpr std::string_view kVessels = "vessels", kSkin = "skin", kMuscle = "muscle",
                                  kMirroredBone = "mirrored bone", kImplant = "implant";

/// Returns the name of a part of a label map as lists show it: "muscle". Other names than these stay as they are.
Text partTitle(const std::string& part);

}  // namespace pdr::segment
