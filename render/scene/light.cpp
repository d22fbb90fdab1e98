#include "render/scene/light.h"

#include <cmath>

#include "render/scene/range.h"

namespace pdr {
namespace {

constexpr Range kLightRange{0, 1e30f};  // as float has it: a little more
constexpr Range kPlaceRange{-1e9, 1e9};
constexpr Range kExtentRange{0, 1e9, false};

Result<void> check(const DirectionalLight& light) {
    if (auto ok = checkDirection(light.direction, "direction"); !ok)
        return ok;
    return checkRange(dvec3(light.irradiance), kLightRange, "irradiance");
}

Result<void> check(const RectangleLight& light) {
    for (const auto& ok : {checkRange(light.centreMm, kPlaceRange, "centreMm"), checkDirection(light.normal, "normal"),
                           checkDirection(light.up, "up"), checkRange(light.widthMm, kExtentRange, "widthMm"),
                           checkRange(light.heightMm, kExtentRange, "heightMm"),
                           checkRange(dvec3(light.radiance), kLightRange, "radiance")})
        if (!ok)
            return ok;
    if (glm::length(glm::cross(glm::normalize(light.normal), glm::normalize(light.up))) < 1e-6)
        return Error{"must not point along the normal", "up", ""};
    return {};
}

Result<void> check(const SphereLight& light) {
    for (const auto& ok :
         {checkRange(light.centreMm, kPlaceRange, "centreMm"), checkRange(light.radiusMm, kExtentRange, "radiusMm"),
          checkRange(dvec3(light.radiance), kLightRange, "radiance")})
        if (!ok)
            return ok;
    return {};
}

}  // namespace

Result<void> check(const Light& light) {
    return std::visit([](const auto& kind) { return check(kind); }, light);
}

Result<void> check(const Environment& environment) {
    if (auto ok = checkRange(dvec3(environment.radiance), kLightRange, "radiance"); !ok)
        return ok;
    if (auto ok = checkRange(dvec3(environment.nadir.value_or(vec3(0))), kLightRange, "nadir"); !ok)
        return ok;
    if (environment.image && environment.nadir)
        return Error{"goes with a gradient only, not with a picture", "nadir", "Leave one of the two out."};
    if (!std::isfinite(environment.rotationDegrees))
        return Error{"must be a finite number", "rotationDegrees", ""};
    return {};
}

bool Environment::isBlack() const {
    return radiance == vec3(0) && (image || nadir.value_or(vec3(0)) == vec3(0));
}

}  // namespace pdr
