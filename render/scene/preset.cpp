#include "render/scene/preset.h"

#include <cmath>
#include <utility>

#include "render/scene/field_check.h"
#include "render/scene/field_reader.h"
#include "render/scene/field_writer.h"
#include "render/scene/scene_fields.h"

namespace pdr {
namespace {

/// A panel of the rig. All lengths are in radii of the volume and the directions follow the camera, so the light that
/// reaches the volume's centre depends neither on its size nor on the side it is seen from.
struct Panel {
    dvec3 from;       ///< from the centre, along the camera's right, up and backward; any length but 0
    double distance;  ///< of its centre from the volume's
    double size;      ///< edge length
    vec3 tint;        ///< linear Rec. 709, luminance about 1
};

constexpr Panel kKey{{-0.9, 1.0, 0.9}, 3.0, 1.4, {1.12f, 0.99f, 0.80f}};
constexpr Panel kFill{{1.0, 0.05, 0.9}, 3.0, 3.0, {0.94f, 1.00f, 1.12f}};
constexpr Panel kRim{{0.5, 0.7, -1.0}, 3.0, 2.5, {0.98f, 1.00f, 1.05f}};

RectangleLight placed(const Panel& panel, float radiance, const VolumeGeometry& geometry, const Camera& camera) {
    const dvec3 from = glm::normalize(panel.from.x * camera.right() + panel.from.y * camera.imageUp() -
                                      panel.from.z * camera.forward());
    RectangleLight light;
    light.centreMm = geometry.centreMm() + from * (panel.distance * geometry.radiusMm());
    light.normal = -from;
    light.up = std::abs(glm::dot(from, camera.imageUp())) < 0.99 ? camera.imageUp() : camera.forward();
    light.widthMm = light.heightMm = panel.size * geometry.radiusMm();
    light.radiance = radiance * panel.tint;
    return light;
}

constexpr std::string_view kFormat = "pdrender-preset";

Result<void> check(const Preset& preset) {
    if (auto ok = FieldCheck::check(preset); !ok)
        return ok;
    if (auto ok = preset.transferFunction.check(); !ok)
        return ok;
    return check(preset.window);
}

}  // namespace

Result<Preset> presetFromJson(std::string_view json, std::string_view where) {
    Preset preset;
    const auto read = [&](JsonFields& fields) {
        FieldReader reader(fields);
        describe(reader, preset);
        if (auto ok = check(preset); !ok)
            throw FieldError{ok.error()};
    };
    if (auto ok = readJson(json, where, kFormat, read); !ok)
        return ok.error();
    return preset;
}

std::string presetText(Preset preset) {
    return jsonText(kFormat, FieldWriter::written(preset));
}

Scene withPreset(Scene scene, const Preset& preset) {
    scene.look = preset.name;
    scene.transferFunction = preset.transferFunction;
    scene.phaseG = preset.phaseG;
    scene.gradientFactor = preset.gradientFactor;
    scene.window = preset.window;
    scene.lights = lightRig(preset, scene.volume->geometry(), scene.camera);
    scene.environment = {vec3(preset.ambient), false};
    return scene;
}

std::vector<Light> lightRig(const Preset& preset, const VolumeGeometry& geometry, const Camera& camera) {
    std::vector<Light> lights;
    for (const auto& [panel, radiance] :
         {std::pair(kKey, preset.keyLight), std::pair(kFill, preset.fillLight), std::pair(kRim, preset.rimLight)})
        if (radiance > 0)  // a dark panel would only take samples away from the others
            lights.push_back(placed(panel, radiance, geometry, camera));
    return lights;
}

}  // namespace pdr
