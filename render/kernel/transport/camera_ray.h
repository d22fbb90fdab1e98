#pragma once
/// Camera rays: from a position on the film to a ray inside the volume.

#include "render/kernel/clip.h"
#include "render/kernel/transport/lights.h"

namespace pdr {

/// A ray in the volume, its unit direction in local space, and the light at its end.
struct PathSegment {
    Ray ray;
    vec3 direction;
    int light = -1;  ///< index of the light that the camera sees at the end; -1: none
};

/// Samples a point of the unit disc, uniformly over its area.
PDR_HD inline vec2 sampleUniformDisk(vec2 u) {
    const float radius = std::sqrt(u.x);
    const CirclePoint<float> rim = circlePoint(u.y);
    return {radius * rim.cosine, radius * rim.sine};
}

/// Returns the index of the nearest light that the camera sees along a ray from `eye` (local) closer than `reach`,
/// which becomes its distance; -1 if there is none.
PDR_HD inline int lightInView(const FlatScene& scene, dvec3 eye, dvec3 unit, double& reach) {
    int nearest = -1;
    for (int i = 0; i < scene.lightCount; ++i) {
        if (!scene.lights[i].visible)
            continue;
        // Intersect from a point of the ray just before the light, computed in double: the eye may be far away.
        const dvec3 fromLight = eye - dvec3(scene.lights[i].position);
        const double before = -glm::dot(fromLight, unit) - 2 * scene.lights[i].radius;
        const LightHit hit = intersectLight(scene.lights[i], vec3(fromLight + unit * before), vec3(unit));
        const double distance = before + hit.distance;
        if (hit.met && distance > 0 && distance < reach) {
            reach = distance;
            nearest = i;
        }
    }
    return nearest;
}

/// Returns the part of a camera ray inside the volume. `place`: pixels from the image's upper left corner. `lens`: on
/// the unit disc; (0, 0) for a pinhole. `depths`: where tissue lies, in mm along the view; see FlatViewBounds. The
/// surface in focus of a lens is a plane across the view.
PDR_HD_INLINE PathSegment generateCameraRay(const FlatScene& scene, vec2 place, vec2 lens, vec2 depths) {
    const FlatCamera& camera = scene.camera;
    // Compute in double up to the border of the box: the camera may be far away.
    const dvec2 film = dvec2(place) * camera.perPixel - 0.5;
    const dvec3 offset = camera.right * film.x - camera.up * film.y;
    dvec3 alongView = camera.forward + offset * camera.perspective;
    dvec3 fromEye = offset * (1 - camera.perspective);
    // Start at a point on the lens, and aim at the same point of the plane in focus.
    if (camera.focus > 0) {
        const dvec3 onLens = camera.lensRight * double(lens.x) + camera.lensUp * double(lens.y);
        fromEye += onLens;
        alongView -= onLens / camera.focus;
    }
    const double stretch = glm::length(alongView);  // distance per depth
    const dvec3 unit = alongView * (1 / stretch);
    // Find the light that ends the ray.
    double reach = 1e30;
    const int light = scene.lightsInView ? lightInView(scene, camera.localEye + fromEye, unit, reach) : -1;
    const dvec3 direction = scene.volume.exactIndexFromLocal * unit;
    const dvec3 eye = camera.eye + scene.volume.exactIndexFromLocal * fromEye;
    // Clip the ray to the box, the depths of tissue, the light and the clip planes.
    const Interval<double> box = clipped(eye, direction, dvec3(-0.5), dvec3(scene.volume.lastIndex) + 0.5,
                                         {glm::max(0.0, depths.x * stretch), glm::min(depths.y * stretch, reach)});
    const Interval<double> inside = cut(scene.clip, eye, direction, box);
    if (!(inside.enter < inside.leave))
        return {{vec3(0), vec3(direction), -1}, vec3(unit), light};
    const Ray ray{vec3(eye + direction * inside.enter), vec3(direction), float(inside.leave - inside.enter)};
    return {ray, vec3(unit), light};
}

}  // namespace pdr
