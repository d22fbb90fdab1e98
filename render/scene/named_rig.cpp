#include "render/scene/named_rig.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/scene/lamp.h"
#include "render/scene/orbit.h"
#include "render/scene/sky_image.h"

namespace pdr {
namespace {

constexpr vec3 kWarm{1.12f, 0.99f, 0.80f}, kCool{0.94f, 1.00f, 1.12f}, kWhite{1, 1, 1};

/// Returns a panel whose irradiance at the centre is `share` of the rig's strength.
RigPanel panel(const char* name, dvec3 from, double distance, double edge, double share, vec3 colour = kWhite) {
    RigPanel result{name, from, distance, edge, 1, colour};
    result.radiance = float(share / irradianceOf(result));
    return result;
}

/// Returns one panel in the middle and six around it, from above the brow; together they form one lamp.
std::vector<RigPanel> operatingLamp() {
    constexpr int kAround = 6;
    constexpr double kDistance = 3.5, kEdge = 0.4, kOpening = 0.3;  // slope of the ring as seen from the centre
    const dvec3 axis = glm::normalize(dvec3(-0.15, 1, 0.75));
    const dvec3 right = glm::normalize(glm::cross(axis, dvec3(0, 0, 1))), up = glm::cross(right, axis);
    std::vector<RigPanel> lamp{panel("Lamp", axis, kDistance, kEdge, 1.0 / (kAround + 1))};
    for (int i = 0; i < kAround; ++i) {
        const double angle = 2 * M_PI * i / kAround;
        const dvec3 from = axis + kOpening * (std::cos(angle) * right + std::sin(angle) * up);
        lamp.push_back(panel("Lamp", from, kDistance, kEdge, 1.0 / (kAround + 1)));
    }
    return lamp;
}

/// Returns the eight panels of a photographer's studio: a warm key, and cool strips that draw the edges.
std::vector<RigPanel> studio() {
    constexpr vec3 kKey{1.10f, 1.00f, 0.86f};
    return {panel("Key", {-1, 0.85, 0.75}, 3, 1.3, 1, kKey),
            panel("Fill", {1, 0.05, 0.9}, 3, 3, 0.12, kCool),
            panel("Right strip", {1.25, 0.75, -0.35}, 3, 0.7, 0.105, kCool),
            panel("Right strip", {1.25, 0.1, -0.35}, 3, 0.7, 0.105, kCool),
            panel("Right strip", {1.25, -0.55, -0.35}, 3, 0.7, 0.08, kCool),
            panel("Left strip", {-1.2, 0.5, -0.75}, 3, 0.8, 0.12),
            panel("Left strip", {-1.2, -0.2, -0.75}, 3, 0.8, 0.086),
            panel("Top", {0, 1.5, -0.1}, 3, 1.6, 0.2)};
}

/// A rig of strength 1, and the radiance of the environment that goes with it.
struct Unit {
    std::vector<RigPanel> panels;
    vec3 zenith;
    std::optional<vec3> nadir;
};

Unit unitOf(NamedRig name) {
    constexpr vec3 kFaint(0.004f);
    switch (name) {
        case NamedRig::headlight:
            return {{panel("Headlight", {0.12, 0.2, 1}, 3, 0.5, 1)}, kFaint, {}};
        case NamedRig::threePoint:
            return {{panel("Key", {-1.2, 1.1, 0.45}, 3, 0.8, 1, kWarm), panel("Fill", {1, 0.05, 0.9}, 3, 3, 0.1, kCool),
                     panel("Rim", {0.5, 0.7, -1}, 3, 2.5, 0.5, kCool)},
                    kFaint,
                    {}};
        case NamedRig::operatingLamp:
            return {operatingLamp(), vec3(0.01f), {}};
        case NamedRig::rim:
            return {{panel("Left rim", {-1, 0.5, -0.7}, 3, 1.6, 1, kCool),
                     panel("Right rim", {1, 0.5, -0.7}, 3, 1.6, 1, kWarm), panel("Fill", {0, 0.4, 1}, 3, 2.5, 0.15)},
                    kFaint,
                    {}};
        case NamedRig::softBox:
            return {{panel("Soft box", {-0.7, 0.9, 0.9}, 2.5, 4, 1)}, vec3(0.015f), {}};
        case NamedRig::studio:
            return {studio(), vec3(0.007f), {}};
        case NamedRig::sky:
            return {
                {panel("Sun", {-0.7, 1, 0.6}, 3, 0.5, 0.5, kWarm)}, {0.23f, 0.26f, 0.31f}, vec3(0.08f, 0.07f, 0.06f)};
    }
    return {};
}

/// Returns the irradiance that an environment is worth. It also lights what a panel leaves in shadow, so it counts as
/// if from twice the half sphere.
double strengthOf(const Environment& environment) {
    const vec3 mean = (environment.radiance + environment.nadir.value_or(environment.radiance)) / 2.0f;
    return 2 * M_PI * luminanceOf(mean);
}

/// Returns whether two panels are equal but for their strength and the rounding of a rotation back and forth.
bool standsAs(const RigPanel& panel, RigPanel other) {
    if (glm::length(glm::normalize(panel.from) - glm::normalize(other.from)) > 1e-6)
        return false;
    other.from = panel.from;
    other.radiance = panel.radiance;
    return other == panel;
}

Environment around(Environment environment, const Unit& unit, float strength) {
    environment.radiance = strength * unit.zenith;
    environment.nadir = unit.nadir ? std::optional(strength * *unit.nadir) : std::nullopt;
    return withoutImage(environment);
}

}  // namespace

double strengthOf(const Lighting& lighting) {
    double strongest = strengthOf(lighting.environment);
    for (const Lamp& lamp : lampsOf(lighting.rig))
        strongest = std::max(strongest, lamp.irradiance);
    return strongest;
}

Lighting litBy(Lighting lighting, NamedRig name) {
    const Unit unit = unitOf(name);
    const double before = strengthOf(lighting);
    lighting.rig.panels = unit.panels;
    lighting.environment = around(lighting.environment, unit, 1);
    const auto factor = float((before > 0 ? before : 1) / strengthOf(lighting));
    for (RigPanel& panel : lighting.rig.panels)
        panel.radiance *= factor;
    lighting.environment = around(lighting.environment, unit, factor);
    return lighting;
}

Lighting turned(Lighting lighting, dvec2 drag, const Camera& camera) {
    lighting.rig = turned(lighting.rig, drag, camera);
    if (!lighting.environment.image)
        return lighting;
    // about the patient's axis, in half turns
    const double upwards = (drag.x * camera.imageUp() + drag.y * camera.right()).z;
    const double turn = lighting.environment.rotationDegrees - 180 * upwards;  // positive from the back to the left
    lighting.environment.rotationDegrees = std::remainder(turn, 360);
    return lighting;
}

Environment withRadiance(Environment environment, double radiance) {
    const double before = luminanceOf(environment.radiance);
    if (before > 0 && radiance > 0) {
        const auto factor = float(radiance / before);
        environment.radiance *= factor;
        if (environment.nadir)
            *environment.nadir *= factor;
        return environment;
    }
    environment.radiance = vec3(float(radiance));
    environment.nadir.reset();
    return environment;
}

std::optional<NamedRig> nameOf(const LightRig& rig) {
    for (const NamedRig name : kNamedRigs)
        if (std::ranges::equal(unitOf(name).panels, rig.panels, standsAs))
            return name;
    return std::nullopt;
}

}  // namespace pdr
