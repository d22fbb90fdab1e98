#pragma once
/// Names, ranges and meanings of the fields of lights and of the environment.

#include <optional>
#include <string>
#include <variant>

#include "render/scene/fields/ranges.h"
#include "render/scene/light.h"

namespace pdr {

template <class Visit>
void describe(Visit& visit, DirectionalLight& light) {
    visit.direction({"direction", "the way the light travels", {}, kRequired}, light.direction);
    visit({"irradiance", "colour: on a plane that faces the light", kRadiance, kRequired}, light.irradiance);
}

template <class Visit>
void describe(Visit& visit, RectangleLight& light) {
    visit({"centreMm", "its centre [mm]", kPlaceMm, kRequired}, light.centreMm);
    visit.direction({"normal", "the side it shines to", {}, kRequired}, light.normal);
    visit.direction({"up", "along its height; not along the normal", {}, kRequired}, light.up);
    visit({"widthMm", "[mm]", kExtentMm, kRequired}, light.widthMm);
    visit({"heightMm", "[mm]", kExtentMm, kRequired}, light.heightMm);
    visit({"radiance", "colour", kRadiance, kRequired}, light.radiance);
    visit({"visible", "whether the camera sees it, from its shining side"}, light.visible);
}

template <class Visit>
void describe(Visit& visit, SphereLight& light) {
    visit({"centreMm", "its centre [mm]", kPlaceMm, kRequired}, light.centreMm);
    visit({"radiusMm", "[mm]", kExtentMm, kRequired}, light.radiusMm);
    visit({"radiance", "colour", kRadiance, kRequired}, light.radiance);
    visit({"visible", "whether the camera sees it"}, light.visible);
}

/// The environment as files write it, where its image is a path.
struct EnvironmentFields {
    Environment environment;
    std::optional<std::string> image;
};

template <class Visit>
void describe(Visit& visit, EnvironmentFields& fields) {
    Environment& environment = fields.environment;
    visit({"image",
           "an OpenEXR image of the surroundings, latitude-longitude: its top row is towards the head, its middle at "
           "the back, its right half on the patient's left. Bright spots are aimed at"},
          fields.image);
    if (Visit::kReads && fields.image)
        environment.radiance = vec3(1);
    visit({"radiance",
           "colour; with `nadir`: what comes from straight above (towards the head); with `image`: what the image is "
           "multiplied by, 1 where it is absent",
           kRadiance, !fields.image},
          environment.radiance);
    if (Visit::kBranches || !fields.image)
        visit({"nadir", "colour from straight below; in between it changes evenly with the height", kRadiance},
              environment.nadir);
    if (Visit::kBranches || fields.image)
        visit({"rotationDegrees", "turns the image about the patient's axis, from the back towards the left"},
              environment.rotationDegrees);
    visit({"visible", "whether the camera sees it behind the volume; it lights the volume either way"},
          environment.visible);
}

/// An entry of the list `lights`.
using LightFields = std::variant<DirectionalLight, RectangleLight, SphereLight, EnvironmentFields>;

inline LightFields freshLight(std::size_t kind) {
    switch (kind) {
        case 0:
            return DirectionalLight{};
        case 1:
            return RectangleLight{};
        case 2:
            return SphereLight{};
        default:
            return EnvironmentFields{};
    }
}

inline constexpr Words<std::size_t, 4> kLightWords{
    {{"directional", 0}, {"rectangle", 1}, {"sphere", 2}, {"environment", 3}}};

template <class Visit>
void describe(Visit& visit, LightFields& light) {
    std::size_t kind = light.index();
    visit.word({"type", "what it is", {}, kRequired}, kind, kLightWords);
    if (kind != light.index())
        light = freshLight(kind);
    std::visit([&](auto& one) { describe(visit, one); }, light);
}

}  // namespace pdr
