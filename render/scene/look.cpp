#include "render/scene/look.h"

#include <cmath>
#include <utility>

#include "render/scene/field_check.h"
#include "render/scene/fields/look_fields.h"

namespace pdr {
namespace {

/// A rectangle light of the rig. All lengths are in radii of the volume and the directions follow the camera, so the
/// light that reaches the volume's centre depends neither on its size nor on the side it is seen from.
struct RigLight {
    dvec3 from;       ///< from the centre, along the camera's right, up and backward; any length but 0
    double distance;  ///< of its centre from the volume's
    double size;      ///< edge length
    vec3 tint;        ///< linear Rec. 709, luminance about 1
};

constexpr RigLight kKey{{-0.9, 1.0, 0.9}, 3.0, 1.4, {1.12f, 0.99f, 0.80f}};
constexpr RigLight kFill{{1.0, 0.05, 0.9}, 3.0, 3.0, {0.94f, 1.00f, 1.12f}};
constexpr RigLight kRim{{0.5, 0.7, -1.0}, 3.0, 2.5, {0.98f, 1.00f, 1.05f}};

RectangleLight placed(const RigLight& spec, float radiance, const VolumeGeometry& geometry, const Camera& camera) {
    const dvec3 from =
        glm::normalize(spec.from.x * camera.right() + spec.from.y * camera.imageUp() - spec.from.z * camera.forward());
    RectangleLight light;
    light.centreMm = geometry.centreMm() + from * (spec.distance * geometry.radiusMm());
    light.normal = -from;
    light.up = std::abs(glm::dot(from, camera.imageUp())) < 0.99 ? camera.imageUp() : camera.forward();
    light.widthMm = light.heightMm = spec.size * geometry.radiusMm();
    light.radiance = radiance * spec.tint;
    return light;
}

}  // namespace

Result<void> check(const Look& look) {
    if (auto ok = FieldCheck::check(look); !ok)
        return ok;
    if (auto ok = look.transferFunction.check(); !ok)
        return ok;
    return check(look.window);
}

Scene withLook(Scene scene, const Look& look) {
    scene.transferFunction = look.transferFunction;
    scene.phaseG = look.phaseG;
    scene.gradientFactor = look.gradientFactor;
    scene.window = look.window;
    scene.lights = panelsOf(look.rig, scene.volume->geometry(), scene.camera);
    scene.environment = look.environment;
    return scene;
}

std::vector<Light> panelsOf(const LightRig& rig, const VolumeGeometry& geometry, const Camera& camera) {
    const Camera& reference = rig.follows == LightRig::Follows::camera
                                  ? camera
                                  : standardView(StandardView::anterior, geometry.centreMm(), geometry.radiusMm(), 1);
    std::vector<Light> lights;
    for (const auto& [spec, radiance] :
         {std::pair(kKey, rig.key), std::pair(kFill, rig.fill), std::pair(kRim, rig.rim)})
        if (radiance > 0)  // a dark light would only take samples away from the others
            lights.push_back(placed(spec, radiance, geometry, reference));
    return lights;
}

}  // namespace pdr
