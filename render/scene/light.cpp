#include "render/scene/light.h"

#include <cmath>

#include "render/scene/field_check.h"
#include "render/scene/fields/light_fields.h"

namespace pdr {
namespace {

Result<void> checkRules(const RectangleLight& light) {
    if (glm::length(glm::cross(glm::normalize(light.normal), glm::normalize(light.up))) < 1e-6)
        return Error{phrase("must not point along the normal"), "up", ""};
    return {};
}
Result<void> checkRules(const auto&) {
    return {};
}

}  // namespace

Result<void> check(const Light& light) {
    return std::visit(
        [](const auto& one) {
            const Result<void> ranges = FieldCheck::check(one);
            return ranges ? checkRules(one) : ranges;
        },
        light);
}

Result<void> check(const Environment& environment) {
    if (environment.image && environment.nadir)
        return Error{phrase("goes with a gradient only, not with an image"), "nadir",
                     phrase("Leave one of the two out.")};
    EnvironmentFields fields{environment, {}};
    if (auto ok = FieldCheck::check(fields); !ok)
        return ok;
    if (!std::isfinite(environment.rotationDegrees))
        return Error{phrase("must be a finite number"), "rotationDegrees", ""};
    return {};
}

bool Environment::isBlack() const {
    return radiance == vec3(0) && (image || nadir.value_or(vec3(0)) == vec3(0));
}

}  // namespace pdr
