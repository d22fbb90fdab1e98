#pragma once
/// The lights of a scene, in patient space (LPS, mm); radiance and irradiance are linear Rec. 709.

#include <memory>
#include <optional>
#include <variant>

#include "render/base/portable.h"
#include "render/base/result.h"
#include "render/scene/environment_image.h"

namespace pdr {

/// Parallel light.
struct DirectionalLight {
    dvec3 direction{0, 1, 0};  ///< direction in which the light travels; any length but 0
    vec3 irradiance{1.0f};     ///< on a plane facing the light; [0, 1e30]
    bool operator==(const DirectionalLight&) const = default;
};

/// A flat rectangle that emits light to the side of its normal.
struct RectangleLight {
    dvec3 centreMm{0};      ///< each in [-1e9, 1e9]
    dvec3 normal{0, 1, 0};  ///< any length but 0
    dvec3 up{0, 0, 1};      ///< not along the normal
    double widthMm = 100;   ///< (0, 1e9]
    double heightMm = 100;  ///< (0, 1e9]
    vec3 radiance{1.0f};    ///< [0, 1e30]
    bool visible = false;   ///< whether the camera sees it, from its emitting side
    bool operator==(const RectangleLight&) const = default;
};

/// A sphere that emits light to all sides; it is dark inside.
struct SphereLight {
    dvec3 centreMm{0};     ///< each in [-1e9, 1e9]
    double radiusMm = 50;  ///< (0, 1e9]
    vec3 radiance{1.0f};   ///< [0, 1e30]
    bool visible = false;  ///< whether the camera sees it
    bool operator==(const SphereLight&) const = default;
};

using Light = std::variant<DirectionalLight, RectangleLight, SphereLight>;

/// Light from all around: constant, a vertical gradient, or an image.
struct Environment {
    vec3 radiance{0.0f};        ///< [0, 1e30]; an image is multiplied by it
    bool visible = true;        ///< whether the camera sees it behind the volume
    std::optional<vec3> nadir;  ///< radiance from below, changing evenly with height to `radiance` above; [0, 1e30]
    std::shared_ptr<const EnvironmentImage> image;  ///< replaces a gradient; has passed its check()
    double rotationDegrees = 0;  ///< rotates the image about the patient's axis, from the back towards the left; finite

    bool isBlack() const;
    bool operator==(const Environment&) const = default;
};

/// Checks the ranges above, and that the light can be rendered; `where` of an error is the field's name within the
/// light.
Result<void> check(const Light& light);
Result<void> check(const Environment& environment);

}  // namespace pdr
