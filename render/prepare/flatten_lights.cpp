#include "render/prepare/flatten_lights.h"

#include <algorithm>
#include <cmath>

#include "render/scene/scene.h"

namespace pdr {

namespace {

FlatLight flatLight(const DirectionalLight& light, dvec3) {
    FlatLight flat{.type = LightType::directional, .radiance = light.irradiance};
    flat.normal = vec3(-glm::normalize(light.direction));
    return flat;
}

FlatLight flatLight(const RectangleLight& light, dvec3 centreMm) {
    const dvec3 normal = glm::normalize(light.normal);
    const dvec3 side = glm::normalize(glm::cross(light.up, normal));
    return {.type = LightType::rectangle,
            .radiance = light.radiance,
            .position = vec3(light.centreMm - centreMm),
            .normal = vec3(normal),
            .halfU = vec3(side * (light.widthMm / 2)),
            .halfV = vec3(glm::cross(normal, side) * (light.heightMm / 2)),
            .area = float(light.widthMm * light.heightMm),
            .visible = light.visible};
}

FlatLight flatLight(const SphereLight& light, dvec3 centreMm) {
    return {.type = LightType::sphere,
            .radiance = light.radiance,
            .position = vec3(light.centreMm - centreMm),
            .radius = float(light.radiusMm),
            .visible = light.visible};
}

FlatEnvironment flatEnvironment(const Environment& environment, const EnvironmentTables* tables) {
    FlatEnvironment flat{};
    flat.zenith = environment.radiance;
    flat.nadir = environment.nadir.value_or(environment.radiance);
    if (tables == nullptr)
        return flat;
    flat.turn = float(std::remainder(environment.rotationDegrees, 360.0) / 360);
    flat.size = tables->image->size;
    flat.texels = tables->image->texels.data();
    flat.pdf = tables->density.data();
    flat.rowSums = tables->rowSums.data();
    flat.columnSums = tables->columnSums.data();
    return flat;
}

}  // namespace

void flattenLights(PreparedScene& prepared, const Scene& scene) {
    const dvec3 centre = scene.volume->geometry().centreMm();
    for (const Light& light : scene.lights)
        prepared.lights.push_back(std::visit([&](const auto& one) { return flatLight(one, centre); }, light));
    FlatScene& flat = prepared.flat;
    flat.lights = prepared.lights.data();
    flat.lightCount = int(prepared.lights.size());
    prepared.lightTables = lightTables(prepared.lights, flat.volume);
    const LightTables& tables = prepared.lightTables;
    flat.lightSums = tables.sums.empty() ? nullptr : tables.sums.data();
    flat.lightNodes = tables.nodes.data();
    flat.lightNodeCount = int(tables.nodes.size());
    flat.lightsInView = !isProjection(scene.model) && std::ranges::any_of(prepared.lights, &FlatLight::visible);
    flat.environment = flatEnvironment(scene.environment, prepared.environment.get());
    flat.environment.visible = showsEnvironment(scene);
    flat.environment.behind = scene.background.value_or(vec3(0));
    const bool even = flat.environment.texels == nullptr && flat.environment.zenith == flat.environment.nadir;
    flat.plainBackground = !flat.lightsInView && (even || !flat.environment.visible);
}

}  // namespace pdr
