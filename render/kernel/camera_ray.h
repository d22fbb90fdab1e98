#pragma once
/// From a place on the film to a ray inside the volume.

#include "render/kernel/flat_scene.h"
#include "render/kernel/ray.h"

namespace pdr {

/// A camera ray: the ray in the volume, its unit direction in local space, and the distance [mm] from the camera to the
/// ray's origin.
struct CameraRay {
    Ray ray;
    vec3 direction;
    float distance;
};

/// `place`: pixels from the image's upper left corner. `depths`: where matter lies, mm along the view; see FlatViewBounds.
PDR_HD inline CameraRay cameraRay(const FlatScene& scene, vec2 place, vec2 depths) {
    const FlatCamera& camera = scene.camera;
    const vec2 film = place / vec2(camera.film) - 0.5f;
    const vec3 offset = camera.right * film.x - camera.up * film.y;
    const vec3 towards = camera.forward + offset * camera.perspective;
    const float stretch = glm::length(towards);  // distance per depth
    CameraRay result;
    result.direction = towards / stretch;

    // In double up to the border of the box: the camera may stand far away.
    const vec3 direction = scene.volume.indexFromLocal * result.direction;
    const dvec3 eye = camera.eye + dvec3(scene.volume.indexFromLocal * (offset * (1 - camera.perspective)));
    double enter = glm::max(0.0, double(depths.x * stretch)), leave = double(depths.y * stretch);
    for (int axis = 0; axis < 3; ++axis) {
        const double low = -0.5, high = double(scene.volume.lastIndex[axis]) + 0.5;
        if (direction[axis] == 0) {
            if (!(eye[axis] >= low && eye[axis] < high))
                leave = -1;
            continue;
        }
        const double inverse = double(1 / direction[axis]);
        const double a = (low - eye[axis]) * inverse, b = (high - eye[axis]) * inverse;
        enter = glm::max(enter, glm::min(a, b));
        leave = glm::min(leave, glm::max(a, b));
    }
    result.ray = {vec3(eye + dvec3(direction) * enter), direction, float(leave - enter)};
    result.distance = float(enter);
    return result;
}

}  // namespace pdr
