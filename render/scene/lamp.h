#pragma once
/// The panels of a rig that bear one name are one lamp: they are moved, dimmed and enlarged together.

#include <string>
#include <vector>

#include "render/scene/light_rig.h"

namespace pdr {

struct Lamp {
    std::string name;
    dvec3 from;         ///< where it stands: unit, the axes of RigPanel::from; of several panels the mean
    double irradiance;  ///< that it brings to a plane at the volume's centre that faces it; luminance
    double edge;        ///< of its first panel [radii of the volume]
    vec3 colour;        ///< likewise
};

/// In the order in which they come first in the rig.
std::vector<Lamp> lampsOf(const LightRig& rig);

// All of these leave a rig without such a lamp as it is.

/// The lamp at `from`, of any length but 0; its panels stand to each other as before.
LightRig withLampFrom(LightRig rig, const std::string& name, dvec3 from);
/// The lamp with that irradiance, >= 0; a dark one gets it from all its panels alike.
LightRig withLampStrength(LightRig rig, const std::string& name, double irradiance);
/// Its panels with that edge [radii of the volume], > 0, and as strong as before.
LightRig withLampEdge(LightRig rig, const std::string& name, double edge);

}  // namespace pdr
