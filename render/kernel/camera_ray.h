#pragma once
/// From a place on the film to a ray inside the volume.

#include "render/kernel/flat_scene.h"
#include "render/kernel/ray.h"

namespace pdr {

/// A camera ray in the volume, and its unit direction in local space.
struct CameraRay {
    Ray ray;
    vec3 direction;
};

/// `place`: pixels from the image's upper left corner. `depths`: where matter lies, mm along the view; see
/// FlatViewBounds.
PDR_HD inline CameraRay cameraRay(const FlatScene& scene, vec2 place, vec2 depths) {
    const FlatCamera& camera = scene.camera;
    // In double up to the border of the box: the camera may stand far away.
    const dvec2 film = dvec2(place) * camera.perPixel - 0.5;
    const dvec3 offset = camera.right * film.x - camera.up * film.y;
    const dvec3 towards = camera.forward + offset * camera.perspective;
    const double stretch = glm::length(towards);  // distance per depth
    const dvec3 unit = towards * (1 / stretch);
    const dvec3 direction = scene.volume.exactIndexFromLocal * unit;
    const dvec3 eye = camera.eye + scene.volume.exactIndexFromLocal * (offset * (1 - camera.perspective));
    const Interval<double> inside = clipped(eye, direction, dvec3(-0.5), dvec3(scene.volume.lastIndex) + 0.5,
                                            Interval<double>{glm::max(0.0, depths.x * stretch), depths.y * stretch});
    const Ray ray{vec3(eye + direction * inside.enter), vec3(direction), float(inside.leave - inside.enter)};
    return {ray, vec3(unit)};
}

}  // namespace pdr
