#include "render/scene/lamp.h"

#include <algorithm>
#include <cmath>

#include "render/scene/orbit.h"

namespace pdr {
namespace {

/// The shortest rotation from direction `a` to direction `b`, both unit vectors.
struct Turn {
    dvec3 axis;
    double angle;
};

Turn turnBetween(dvec3 a, dvec3 b) {
    dvec3 axis = glm::cross(a, b);
    const double angle = std::atan2(glm::length(axis), glm::dot(a, b));
    if (glm::length(axis) < 1e-12)  // parallel: any perpendicular axis will do
        axis = glm::cross(a, std::abs(a.x) < 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0));
    return {glm::normalize(axis), angle};
}

template <class Change>
LightRig changed(LightRig rig, const std::string& name, Change change) {
    for (RigPanel& panel : rig.panels)
        if (panel.name == name)
            change(panel);
    return rig;
}

}  // namespace

std::vector<Lamp> lampsOf(const LightRig& rig) {
    std::vector<Lamp> lamps;
    for (const RigPanel& panel : rig.panels) {
        auto lamp = std::ranges::find(lamps, panel.name, &Lamp::name);
        if (lamp == lamps.end())
            lamp = lamps.insert(lamps.end(), {panel.name, dvec3(0), 0, panel.edge, panel.colour});
        lamp->from += glm::normalize(panel.from);
        lamp->irradiance += irradianceOf(panel);
    }
    for (Lamp& lamp : lamps)
        lamp.from = glm::length(lamp.from) > 1e-6 ? glm::normalize(lamp.from) : dvec3(0, 0, 1);
    return lamps;
}

LightRig withLampFrom(LightRig rig, const std::string& name, dvec3 from) {
    for (const Lamp& lamp : lampsOf(rig)) {
        if (lamp.name != name)
            continue;
        const Turn turn = turnBetween(lamp.from, glm::normalize(from));
        return changed(std::move(rig), name,
                       [&](RigPanel& panel) { panel.from = turned(panel.from, turn.axis, turn.angle); });
    }
    return rig;
}

LightRig withLampStrength(LightRig rig, const std::string& name, double irradiance) {
    double before = 0, alike = 0;
    changed(rig, name, [&](RigPanel panel) {
        before += irradianceOf(panel);
        panel.radiance = 1;
        alike += irradianceOf(panel);
    });
    if (!(alike > 0))  // its colour is black
        return rig;
    return changed(std::move(rig), name, [&](RigPanel& panel) {
        const double radiance = before > 0 ? double(panel.radiance) * irradiance / before : irradiance / alike;
        panel.radiance = float(std::clamp(radiance, 0.0, RigPanel::kBrightest));
    });
}

LightRig withLampEdge(LightRig rig, const std::string& name, double edge) {
    return changed(std::move(rig), name, [&](RigPanel& panel) {
        const double radiance = double(panel.radiance) * panel.edge * panel.edge / (edge * edge);
        panel.radiance = float(std::min(radiance, RigPanel::kBrightest));
        panel.edge = edge;
    });
}

}  // namespace pdr
