#include "render/scene/edit/view_geometry.h"

#include <cmath>

#include "render/scene/perspective.h"

namespace pdr {
namespace {

/// Smallest depth of a visible place [mm before the eye]: nearer, it could be seen anywhere.
constexpr double kNearestMm = 1e-3;

}  // namespace

ViewGeometry::ViewGeometry(const Camera& camera, double aspect)
    : camera_(camera),
      aspect_(aspect),
      heightPerDepth_(heightPerDepth(camera.fovDegrees)),
      forward_(camera.forward()),
      right_(camera.right()),
      up_(camera.imageUp()) {}

double ViewGeometry::depth(dvec3 placeMm) const {
    return glm::dot(placeMm - camera_.eyeMm, forward_);
}

double ViewGeometry::heightMm(dvec3 placeMm) const {
    const double depth = this->depth(placeMm);
    if (depth < kNearestMm)
        return 0;
    return camera_.type == Camera::Type::orthographic ? camera_.heightMm : heightPerDepth_ * depth;
}

std::optional<dvec2> ViewGeometry::at(dvec3 placeMm) const {
    const double height = heightMm(placeMm);
    if (height <= 0)
        return std::nullopt;
    const dvec3 offset = placeMm - camera_.eyeMm;
    return dvec2(0.5 + glm::dot(offset, right_) / (height * aspect_), 0.5 - glm::dot(offset, up_) / height);
}

std::optional<std::pair<dvec2, dvec2>> ViewGeometry::lineAt(dvec3 fromMm, dvec3 toMm) const {
    const double from = depth(fromMm) - kNearestMm, to = depth(toMm) - kNearestMm;
    if (from < 0 && to < 0)
        return std::nullopt;
    const auto border = [&] { return glm::mix(fromMm, toMm, from / (from - to)) + forward_ * (kNearestMm / 2); };
    const auto a = at(from < 0 ? border() : fromMm), b = at(to < 0 ? border() : toMm);
    return a && b ? std::optional(std::pair(*a, *b)) : std::nullopt;
}

SightLine ViewGeometry::under(dvec2 point) const {
    const double height = heightMm(camera_.targetMm);
    const dvec3 across = right_ * ((point.x - 0.5) * height * aspect_) + up_ * ((0.5 - point.y) * height);
    if (camera_.type == Camera::Type::orthographic)
        return {camera_.eyeMm + across, forward_};
    return {camera_.eyeMm, glm::normalize(camera_.targetMm - camera_.eyeMm + across)};
}

}  // namespace pdr
