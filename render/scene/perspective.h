#pragma once
/// The size of a perspective image.

#include <glm/trigonometric.hpp>

#include "render/base/angles.h"

namespace pdr {

/// Returns the visible height at a depth of 1, for a vertical field of view in (0, 180) degrees.
inline double heightPerDepth(double fovDegrees) {
    return 2 * tangent(glm::radians(fovDegrees) / 2);
}

}  // namespace pdr
