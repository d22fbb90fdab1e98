#pragma once
/// Lamps of a light rig. Panels with the same name form one lamp: they are moved, dimmed and enlarged together.

#include <string>
#include <vector>

#include "render/scene/light_rig.h"

namespace pdr {

struct Lamp {
    std::string name;
    dvec3 from;         ///< direction of the lamp, unit, in the axes of RigPanel::from; the mean of its panels
    double irradiance;  ///< irradiance on a plane at the volume's centre that faces the lamp; luminance
    double edge;        ///< edge of its first panel [radii of the volume]
    vec3 colour;        ///< colour of its first panel
};

/// Returns the lamps of `rig` in the order of their first panels.
std::vector<Lamp> lampsOf(const LightRig& rig);

// All of these return the rig unchanged if it has no lamp of that name.

/// Moves a lamp to `from`, of any length but 0; its panels keep their relative positions.
LightRig withLampFrom(LightRig rig, const std::string& name, dvec3 from);
/// Scales a lamp to that irradiance, >= 0; if it was dark, all its panels get the same radiance.
LightRig withLampStrength(LightRig rig, const std::string& name, double irradiance);
/// Sets the edge of a lamp's panels [radii of the volume], > 0, and keeps their irradiance.
LightRig withLampEdge(LightRig rig, const std::string& name, double edge);

}  // namespace pdr
