#pragma once
/// The sides of a patient, and views along the patient's axes.

#include <array>
#include <vector>

#include "render/scene/camera.h"

namespace pdr::test {

struct Side {
    char letter;
    dvec3 way;  ///< direction, LPS
};
inline constexpr std::array<Side, 6> kSides{
    {{'L', {1, 0, 0}}, {'R', {-1, 0, 0}}, {'P', {0, 1, 0}}, {'A', {0, -1, 0}}, {'H', {0, 0, 1}}, {'F', {0, 0, -1}}}};

/// Returns the 24 views along an axis, upright along another axis, from 600 mm away: `fovDegrees` wide in perspective,
/// `heightMm` high in parallel projection.
inline std::vector<Camera> axisViews(Camera::Type type, double fovDegrees, double heightMm) {
    std::vector<Camera> cameras;
    for (const Side& forward : kSides)
        for (const Side& up : kSides)
            if (glm::dot(forward.way, up.way) == 0) {
                Camera camera;
                camera.type = type;
                camera.eyeMm = -600.0 * forward.way;
                camera.up = up.way;
                camera.fovDegrees = fovDegrees;
                camera.heightMm = heightMm;
                cameras.push_back(camera);
            }
    return cameras;
}

}  // namespace pdr::test
