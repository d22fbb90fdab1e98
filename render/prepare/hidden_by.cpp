#include "render/prepare/hidden_by.h"

#include <algorithm>
#include <cmath>

#include "render/kernel/mask.h"
#include "render/kernel/transport/camera_ray.h"
#include "render/kernel/walk/piece_walk.h"

namespace pdr {

namespace {

/// Returns the point of the film that shows `local` [mm], in pixels from the upper left corner; none at and behind the
/// eye. It is the inverse of generateCameraRay().
std::optional<vec2> filmPlace(const FlatCamera& camera, dvec3 local) {
    const dvec3 offset = local - camera.localEye;
    const double depth = glm::dot(offset, camera.forward);
    if (!(depth > 0))
        return std::nullopt;
    const double stretch = camera.perspective > 0 ? depth : 1;
    const dvec2 film(glm::dot(offset, camera.right) / glm::dot(camera.right, camera.right),
                     -glm::dot(offset, camera.up) / glm::dot(camera.up, camera.up));
    return vec2((film / stretch + 0.5) / camera.perPixel);
}

/// How far beyond a plane a place still lies on it: a place picked on the face of a cut is not cut away [mm].
constexpr double kOnPlaneMm = 1e-3;

/// The tissue that a ray passes.
struct Passed {
    double depth = 0;     ///< optical depth
    double tissueMm = 0;  ///< length with an extinction above 0
};

template <Tissue Kind>
Passed passedOn(const FlatScene& scene, const Ray& ray) {
    Passed passed;
    PieceWalk<float, Kind> walk;
    walk.start(scene.majorants, {ray.origin.x, ray.origin.y, ray.origin.z},
               {ray.direction.x, ray.direction.y, ray.direction.z}, ray.length);
    while (walk.going())
        walk.step(scene, [&](const auto& way, bool ready, bool) {
            const OpticsAlong<float> along = opticsAlong(scene.optics, way.piece, way.hu);
            float extinction = along.meanExtinction;
            if constexpr (Kind == Tissue::parted)
                extinction = PartedExtinction<float>{along, way.hu, way.weight, way.masked, way.mixed}.mean();
            if constexpr (Kind == Tissue::masked)
                extinction = seenAlong(along, way.weight).meanExtinction;
            if (ready && extinction > 0) {
                passed.depth += double(extinction) * double(way.length);
                passed.tissueMm += double(way.length);
            }
            return ready;
        });
    return passed;
}

bool isCutAway(const FlatScene& scene, dvec3 index) {
    for (int i = 0; i < scene.clip.count; ++i)
        if (glm::dot(dvec3(scene.clip.planes[i].normal), index) > double(scene.clip.planes[i].offset) + kOnPlaneMm)
            return true;
    return isMasked(scene) && weightAt(scene, vec3(index)) < 0.5f;
}

bool showsAllDepths(FlatModel model) {
    return model == FlatModel::absorption || model == FlatModel::emission || model == FlatModel::maximumIntensity;
}

}  // namespace

std::optional<HiddenBy> hiddenBy(const PreparedScene& scene, dvec3 placeMm) {
    const FlatScene& flat = scene.flat;
    const VolumeGeometry& geometry = scene.volume->geometry();
    const dvec3 local = placeMm - geometry.centreMm();
    const auto film = filmPlace(flat.camera, local);
    if (!film)
        return std::nullopt;
    const bool cutAway = isCutAway(flat, dvec3(glm::inverse(geometry.patientFromIndex) * dvec4(placeMm, 1)));
    if (showsAllDepths(flat.optics.model))
        return HiddenBy{1, 0, cutAway};
    const PathSegment segment = generateCameraRay(flat, *film, vec2(0), vec2(0, 1e30f));
    Ray before = segment.ray;
    const dvec3 fromStart = local - dvec3(localPosition(flat.volume, before.origin));
    before.length = std::min(before.length, float(glm::dot(fromStart, dvec3(segment.direction))));
    if (!(before.length > 0))
        return HiddenBy{1, 0, cutAway};
    const Passed passed = forTissue(flat, [&]<Tissue Kind>() { return passedOn<Kind>(flat, before); });
    return HiddenBy{std::exp(-passed.depth), passed.tissueMm, cutAway};
}

}  // namespace pdr
