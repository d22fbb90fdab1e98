#pragma once
/// A named look: transfer function, window, surface, phase, light rig and exposure, independent of the patient.

#include <string>
#include <string_view>
#include <vector>

#include "render/base/result.h"
#include "render/film/display.h"
#include "render/scene/scene.h"

namespace pdr {

struct Preset {
    std::string name;  ///< for the menu: "CT bone"
    TransferFunction transferFunction;
    float phaseG = 0;
    float gradientFactor = 0;
    HuWindow window;
    float keyLight = 1;      ///< radiance scale of the main panel; [0, 1e6]
    float fillLight = 0.3f;  ///< of the panel on the other side
    float rimLight = 0.5f;   ///< of the panel behind
    float ambient = 0.1f;    ///< radiance of the environment (not seen by the camera)
    Display display;
    bool operator==(const Preset&) const = default;
};

/// Reads one preset from JSON text ("format": "pdrender-preset"). `where` is used in error texts.
Result<Preset> presetFromJson(std::string_view json, std::string_view where);
/// The text that presetFromJson() reads as an equal preset, to the bit.
std::string presetText(Preset preset);

/// `scene` with the preset's look and its name; volume, camera, film, seed and revision stay.
Scene withPreset(Scene scene, const Preset& preset);

/// The rig of `preset` about a volume, tied to the camera: key panel upper left, fill right, rim behind.
std::vector<Light> lightRig(const Preset& preset, const VolumeGeometry& geometry, const Camera& camera);

}  // namespace pdr
