#include "ui/measure/mark_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pdr::ui {
namespace {

MarkCurve straight(dvec3 from, dvec3 to, int parts = kCurveParts) {
    MarkCurve curve;
    for (int i = 0; i <= parts; ++i)
        curve.push_back(glm::mix(from, to, double(i) / parts));
    return curve;
}

std::vector<MarkCurve> sidesOf(const std::vector<dvec3>& corners) {
    const int parts = std::max(2, 2 * kCurveParts / int(corners.size()));
    std::vector<MarkCurve> sides;
    for (std::size_t i = 0; i < corners.size(); ++i)
        sides.push_back(straight(corners[i], corners[(i + 1) % corners.size()], parts));
    return sides;
}

/// Returns the ellipse with these half axes, which are perpendicular.
MarkCurve ellipse(dvec3 centre, dvec3 u, dvec3 v) {
    MarkCurve curve;
    for (int i = 0; i <= kCurveParts; ++i) {
        const double turn = 2 * std::numbers::pi * i / kCurveParts;
        curve.push_back(centre + std::cos(turn) * u + std::sin(turn) * v);
    }
    return curve;
}

MarkCurve circle(dvec3 centre, double radius, const Camera& camera) {
    return ellipse(centre, radius * camera.right(), radius * camera.imageUp());
}

MarkCurve ellipseThrough(dvec3 centre, dvec3 end, dvec3 aside) {
    const dvec3 u = end - centre, v = aside - centre;
    return ellipse(centre, u, v - glm::dot(u, v) / std::max(glm::dot(u, u), 1e-300) * u);
}

std::vector<MarkCurve> ballCurves(dvec3 centre, double radius, const Camera& camera, bool slice) {
    if (!slice)
        return {circle(centre, radius, camera)};
    const double depth = glm::dot(centre - camera.targetMm, camera.forward());
    if (std::abs(depth) >= radius)
        return {};
    return {circle(centre - depth * camera.forward(), std::sqrt(radius * radius - depth * depth), camera)};
}

}  // namespace

std::vector<MarkCurve> curvesOf(const ShownMark& mark, const Camera& camera, bool slice) {
    const std::vector<dvec3>& places = mark.placesMm;
    if (places.size() < 2)
        return {};
    if (mark.shape == MarkShape::ball)
        return ballCurves(places[0], glm::distance(places[0], places[1]), camera, slice);
    if (mark.shape == MarkShape::ellipse && places.size() == 3)
        return {ellipseThrough(places[0], places[1], places[2])};
    if (mark.shape == MarkShape::polygon && places.size() > 2)
        return sidesOf(places);
    std::vector<MarkCurve> curves;
    const std::size_t step = mark.shape == MarkShape::lines ? 2 : 1;
    for (std::size_t i = 0; i + 1 < places.size(); i += step)
        curves.push_back(straight(places[i], places[i + 1]));
    return curves;
}

}  // namespace pdr::ui
