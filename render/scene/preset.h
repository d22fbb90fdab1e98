#pragma once
/// A named look, and its files.

#include <string>
#include <string_view>

#include "render/base/result.h"
#include "render/scene/look.h"

namespace pdr {

struct Preset {
    std::string name;  ///< for the menu: "CT bone"
    Look look;
    bool operator==(const Preset&) const = default;
};

/// Reads one preset from JSON text ("format": "pdrender-preset"). `where` is used in error texts.
Result<Preset> presetFromJson(std::string_view json, std::string_view where);
/// The text that presetFromJson() reads as an equal preset, to the bit. Pictures of surroundings are not written.
std::string presetText(Preset preset);

/// `scene` with the preset's look and its name; volume, camera, film, seed and revision stay.
Scene withPreset(Scene scene, const Preset& preset);

}  // namespace pdr
