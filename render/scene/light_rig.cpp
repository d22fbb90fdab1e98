#include "render/scene/light_rig.h"

#include <cmath>

#include "render/scene/field_check.h"
#include "render/scene/fields/rig_fields.h"
#include "render/scene/orbit.h"

namespace pdr {
namespace {

RectangleLight placed(const RigPanel& panel, const VolumeGeometry& geometry, const dmat3& axes) {
    const dvec3 from = glm::normalize(axes * panel.from);
    RectangleLight light;
    light.centreMm = geometry.centreMm() + from * (panel.distance * geometry.radiusMm());
    light.normal = -from;
    light.up = std::abs(glm::dot(from, axes[1])) < 0.99 ? axes[1] : -axes[2];
    light.widthMm = light.heightMm = panel.edge * geometry.radiusMm();
    light.radiance = panel.radiance * panel.colour;
    return light;
}

}  // namespace

Result<void> check(const RigPanel& panel) {
    return FieldCheck::check(panel);
}

std::vector<RigPanel> standardPanels(float key, float fill, float rim) {
    return {{"Key", {-0.9, 1.0, 0.9}, 3.0, 1.4, key, {1.12f, 0.99f, 0.80f}},
            {"Fill", {1.0, 0.05, 0.9}, 3.0, 3.0, fill, {0.94f, 1.00f, 1.12f}},
            {"Rim", {0.5, 0.7, -1.0}, 3.0, 2.5, rim, {0.98f, 1.00f, 1.05f}}};
}

std::optional<vec3> standardScales(const LightRig& rig) {
    if (rig.panels.size() != 3)
        return std::nullopt;
    const vec3 scales(rig.panels[0].radiance, rig.panels[1].radiance, rig.panels[2].radiance);
    const auto standard = standardPanels(scales.x, scales.y, scales.z);
    return rig.panels == standard ? std::optional(scales) : std::nullopt;
}

std::vector<Light> panelsOf(const LightRig& rig, const VolumeGeometry& geometry, const Camera& camera) {
    const dmat3 axes = rigAxes(rig.follows, camera);
    std::vector<Light> lights;
    for (const RigPanel& panel : rig.panels)
        if (panel.radiance > 0)  // a dark light would only take samples away from the others
            lights.emplace_back(placed(panel, geometry, axes));
    return lights;
}

dmat3 rigAxes(LightRig::Follows follows, const Camera& camera) {
    if (follows == LightRig::Follows::patient)  // as in the view from the front
        return {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    return {camera.right(), camera.imageUp(), -camera.forward()};
}

LightRig tiedTo(LightRig rig, LightRig::Follows follows, const Camera& camera) {
    if (follows == rig.follows)
        return rig;
    const dmat3 axes = glm::transpose(rigAxes(follows, camera)) * rigAxes(rig.follows, camera);
    for (RigPanel& panel : rig.panels)
        panel.from = axes * panel.from;
    rig.follows = follows;
    return rig;
}

LightRig turned(LightRig rig, dvec2 drag, const Camera& camera) {
    const double length = glm::length(drag);
    if (length == 0)
        return rig;
    const dvec3 inView = dvec3(drag.y, drag.x, 0) / length;
    const dmat3 fromView = glm::transpose(rigAxes(rig.follows, camera)) * rigAxes(LightRig::Follows::camera, camera);
    for (RigPanel& panel : rig.panels)
        panel.from = turned(panel.from, fromView * inView, length * kHalfTurn);
    return rig;
}

double irradianceOf(const RigPanel& panel) {
    const double radiance = double(panel.radiance * glm::dot(panel.colour, vec3(0.2126f, 0.7152f, 0.0722f)));
    return radiance * panel.edge * panel.edge / (panel.distance * panel.distance);
}

}  // namespace pdr
