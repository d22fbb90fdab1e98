#include "render/measure/area.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace pdr::measure {
namespace {

constexpr double kSmallestSigmas = 3;

/// Returns twice the signed area of the triangle a, b, c.
double turn(dvec3 a, dvec3 b, dvec3 c, dvec3 normal) {
    return glm::dot(normal, glm::cross(b - a, c - a));
}

/// Returns whether the sides a-b and c-d cross, ends excluded.
bool cross(dvec3 a, dvec3 b, dvec3 c, dvec3 d, dvec3 normal) {
    return turn(a, b, c, normal) * turn(a, b, d, normal) < 0 && turn(c, d, a, normal) * turn(c, d, b, normal) < 0;
}

bool crossesItself(std::span<const Place> corners, dvec3 normal) {
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 2; j < count; ++j)
            if (cross(corners[i].mm, corners[i + 1].mm, corners[j].mm, corners[(j + 1) % count].mm, normal))
                return true;
    return false;
}

/// Returns the area, or a bound where it is not known well enough to be told from nothing.
Stated orAtMost(const Stated& area) {
    if (area.value * kSigmas95 < kSmallestSigmas * area.plusMinus())
        return asAtMost(area, area.value + area.plusMinus(), Limit::spread);
    return area;
}

}  // namespace

Result<Stated> polygonArea(std::span<const Place> corners, dvec3 normal) {
    const std::size_t count = corners.size();
    if (count < 3)
        return Error{phrase("an area has at least three corners"), "", "", ErrorKind::refused};
    if (crossesItself(corners, normal))
        return Error{phrase("the outline crosses itself"), "", phrase("Move its corners."), ErrorKind::refused};
    double twice = 0;
    std::vector<dvec3> gradients(count);
    const dvec3 origin = corners[0].mm;  // near the corners, so that no digits are lost
    for (std::size_t n = 0; n < count; ++n) {
        const dvec3 before = corners[(n + count - 1) % count].mm - origin, here = corners[n].mm - origin,
                    after = corners[(n + 1) % count].mm - origin;
        twice += glm::dot(normal, glm::cross(here, after));
        gradients[n] = 0.5 * glm::cross(after - before, normal);
    }
    return orAtMost(propagated(std::abs(twice) / 2, corners, gradients, 0, INFINITY));
}

/// The area is pi |u x v| for vectors u and v from the middle to the other two places, whether or not they are
/// perpendicular: only the part of v across u counts.
Result<Stated> ellipseArea(const Place& middle, const Place& end, const Place& other) {
    const dvec3 u = end.mm - middle.mm, v = other.mm - middle.mm, across = glm::cross(u, v);
    if (across == dvec3(0))
        return Error{phrase("an ellipse has two half axes"), "", phrase("Move an end of one of them."),
                     ErrorKind::refused};
    const double parallelogram = glm::length(across);
    const dvec3 normal = across / parallelogram;
    const dvec3 byEnd = std::numbers::pi * glm::cross(v, normal), byOther = std::numbers::pi * glm::cross(normal, u);
    const Place places[]{middle, end, other};
    const dvec3 gradients[]{-byEnd - byOther, byEnd, byOther};
    return orAtMost(propagated(std::numbers::pi * parallelogram, places, gradients, 0, INFINITY));
}

}  // namespace pdr::measure
