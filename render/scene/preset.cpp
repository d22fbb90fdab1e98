#include "render/scene/preset.h"

#include <cmath>
#include <utility>

#include "render/scene/look_fields.h"
#include "render/scene/range.h"

namespace pdr {
namespace {

constexpr Range kLightScale{0, 1e6};

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

void readLights(JsonFields fields, Preset& preset) {
    fields.optional("key", preset.keyLight);
    fields.optional("fill", preset.fillLight);
    fields.optional("rim", preset.rimLight);
    fields.optional("ambient", preset.ambient);
    fields.finish();
}

Result<void> check(const Preset& preset) {
    if (auto ok = preset.transferFunction.check(); !ok)
        return ok;
    for (const auto& ok : {checkRange(preset.phaseG, {-1, 1, false, false}, "phase.g"),
                           checkRange(preset.gradientFactor, {0, 1e6}, "surface.gradientFactor"), check(preset.window),
                           checkRange(preset.keyLight, kLightScale, "lights.key"),
                           checkRange(preset.fillLight, kLightScale, "lights.fill"),
                           checkRange(preset.rimLight, kLightScale, "lights.rim"),
                           checkRange(preset.ambient, kLightScale, "lights.ambient"),
                           checkRange(preset.display.exposure, {0, 1e30f, false}, "exposure")})
        if (!ok)
            return ok;
    return {};
}

void readPreset(JsonFields& fields, Preset& preset) {
    fields.required("name", preset.name);
    preset.transferFunction = readTransferFunction(fields);
    readPhase(fields, preset.phaseG);
    readSurface(fields, preset.gradientFactor);
    readWindow(fields, preset.window);
    if (fields.has("lights"))
        readLights(fields.object("lights"), preset);
    fields.optional("exposure", preset.display.exposure);
    if (auto ok = check(preset); !ok)
        throw FieldError{ok.error()};
}

}  // namespace

Result<Preset> presetFromJson(std::string_view json, std::string_view where) {
    Preset preset;
    const auto read = [&](JsonFields& fields) { readPreset(fields, preset); };
    if (auto ok = readJson(json, where, "pdrender-preset", read); !ok)
        return ok.error();
    return preset;
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
