#pragma once
/// Panels of light about a volume, whoever's it is. All lengths are in radii of the volume and all directions in the
/// axes of what the rig follows, so the light that reaches the volume's centre depends neither on its size nor, where
/// the rig follows the camera, on the side it is seen from.

#include <optional>
#include <string>
#include <vector>

#include "render/scene/camera.h"
#include "render/scene/light.h"
#include "render/volume/volume.h"

namespace pdr {

/// A square that faces the volume's centre.
struct RigPanel {
    static constexpr double kBrightest = 1e6;
    std::string name;      ///< what the user calls it; panels of one name are one lamp
    dvec3 from{0, 0, 1};   ///< where it stands, seen from the centre: right, up, towards the viewer; any length but 0
    double distance = 3;   ///< of its centre from the volume's; [1, 100]
    double edge = 1;       ///< [1e-3, 100]
    float radiance = 1;    ///< scale of `colour`; [0, kBrightest]; 0: there is no such panel
    vec3 colour{1, 1, 1};  ///< linear Rec. 709; each in [0, 1000]
    bool operator==(const RigPanel&) const = default;
};

/// The ranges above, with the field's name in `where`.
Result<void> check(const RigPanel& panel);

/// The standard panels: key upper left, fill on the other side, rim behind. Radiance scales.
std::vector<RigPanel> standardPanels(float key, float fill, float rim);

struct LightRig {
    static constexpr std::size_t kMostPanels = 64;
    enum class Follows {
        camera,  ///< each view is lit alike
        patient  ///< the panels stand where they do for a view from the front
    };
    std::vector<RigPanel> panels = standardPanels(1, 0.3f, 0.5f);  ///< 1 to kMostPanels
    Follows follows = Follows::camera;
    bool operator==(const LightRig&) const = default;
};

/// The radiance scales of key, fill and rim where the rig's panels are the standard ones but for these.
std::optional<vec3> standardScales(const LightRig& rig);

/// Its panels about a volume seen by `camera`.
std::vector<Light> panelsOf(const LightRig& rig, const VolumeGeometry& geometry, const Camera& camera);

/// The axes of RigPanel::from in patient space while `camera` looks: right, up and towards the viewer as columns.
dmat3 rigAxes(LightRig::Follows follows, const Camera& camera);

/// `rig` tied to what `follows` says from now on, each panel where it is as long as `camera` stays.
LightRig tiedTo(LightRig rig, LightRig::Follows follows, const Camera& camera);

/// `rig` turned about the volume as by a hand on its near side: a drag in fractions of the view's height, x to the
/// right, y down; one height = 180 degrees.
LightRig turned(LightRig rig, dvec2 drag, const Camera& camera);

/// Irradiance that the panel brings to a plane that faces it at the volume's centre, as of a small one; luminance.
double irradianceOf(const RigPanel& panel);

}  // namespace pdr
