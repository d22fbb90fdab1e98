#pragma once
/// Panels of light around a volume, independent of the patient. All lengths are in radii of the volume and all
/// directions in the axes of what the rig follows. The light that reaches the volume's centre therefore depends neither
/// on the volume's size nor, where the rig follows the camera, on the side from which the volume is seen.

#include <optional>
#include <string>
#include <vector>

#include "render/scene/camera.h"
#include "render/scene/light.h"
#include "render/volume/volume.h"

namespace pdr {

/// A square panel that faces the volume's centre.
struct RigPanel {
    static constexpr double kBrightest = 1e6;
    std::string name;      ///< name that the user sees; panels of one name form one lamp
    dvec3 from{0, 0, 1};   ///< direction of the panel from the centre: right, up, towards the viewer; any length but 0
    double distance = 3;   ///< distance of its centre from the volume's centre; [1, 100]
    double edge = 1;       ///< edge of the square; [1e-3, 100]
    float radiance = 1;    ///< scale of `colour`; [0, kBrightest]; 0: the panel is left out
    vec3 colour{1, 1, 1};  ///< linear Rec. 709; each in [0, 1000]
    bool operator==(const RigPanel&) const = default;
};

/// Checks the ranges above; `where` of an error is the field's name.
Result<void> check(const RigPanel& panel);

/// Returns the standard panels: key at the upper left, fill on the other side, rim behind. The arguments are radiance
/// scales.
std::vector<RigPanel> standardPanels(float key, float fill, float rim);

struct LightRig {
    static constexpr std::size_t kMostPanels = 64;
    enum class Follows {
        camera,  ///< the panels move with the camera: each view is lit alike
        patient  ///< the panels stay where they are for a view from the front
    };
    std::vector<RigPanel> panels = standardPanels(1, 0.3f, 0.5f);  ///< 1 to kMostPanels
    Follows follows = Follows::camera;
    bool operator==(const LightRig&) const = default;
};

/// Returns the radiance scales of key, fill and rim if the panels differ from the standard ones only in these; else
/// none.
std::optional<vec3> standardScales(const LightRig& rig);

/// Returns the panels of `rig` as lights around a volume seen by `camera`; dark panels are left out.
std::vector<Light> panelsOf(const LightRig& rig, const VolumeGeometry& geometry, const Camera& camera);

/// Returns the axes of RigPanel::from in patient space for that camera: right, up and towards the viewer as columns.
dmat3 rigAxes(LightRig::Follows follows, const Camera& camera);

/// Returns `rig` tied to `follows`, with each panel at its current place as long as `camera` stays.
LightRig tiedTo(LightRig rig, LightRig::Follows follows, const Camera& camera);

/// Rotates `rig` about the volume, as if the pointer dragged the near side of a sphere around it. The drag is in
/// fractions of the view's height, x to the right, y down; one height = 180 degrees.
LightRig turned(LightRig rig, dvec2 drag, const Camera& camera);

/// Returns the luminance of a colour in linear Rec. 709.
double luminanceOf(vec3 colour);

/// Returns the irradiance of the panel on a plane that faces it at the volume's centre, computed as for a small panel;
/// luminance.
double irradianceOf(const RigPanel& panel);

}  // namespace pdr
