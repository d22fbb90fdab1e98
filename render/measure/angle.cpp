#include "render/measure/angle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/measure/line.h"

namespace pdr::measure {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// Angles nearer to 0 or 180 degrees than this are bounds, and so are those within kNearestSigmas standard deviations.
constexpr double kNearestDegrees = 5, kNearestSigmas = 3;

/// Shortest line with a direction, in standard deviations of its ends.
constexpr double kShortestSpreads = 3;

/// A line as it appears in a plane, or in space.
struct Arm {
    dvec3 direction;  ///< unit vector
    double lengthMm;
    double sigmaMm;  ///< spread of its ends across it
};

/// Returns the arm between two places, projected by `projection`.
Result<Arm> armOf(const DrawnLine& line, const dmat3& projection) {
    const dvec3 reach = projection * (line.to.mm - line.from.mm);
    const double length = glm::length(reach);
    const dvec3 direction = length > 0 ? reach / length : dvec3(0);
    const dmat3 spread = projection * (line.from.spread.total() + line.to.spread.total()) * projection;
    const Arm arm{direction, length, std::sqrt(varianceAcross(spread, direction))};
    if (length <= kShortestSpreads * arm.sigmaMm || length == 0)
        return Error{phrase("a line is too short to have a direction"), "", phrase("Put its ends farther apart."),
                     ErrorKind::refused};
    return arm;
}

/// Returns the derivative of the angle [radians] with respect to the end of arm `u`: across it, away from arm `v`.
dvec3 turning(const Arm& u, const Arm& v) {
    const dvec3 away = glm::dot(u.direction, v.direction) * u.direction - v.direction;
    const double sine = glm::length(away);
    return sine > 0 ? away / (sine * u.lengthMm) : dvec3(0);
}

/// Returns `stated`, or the bound that it is near 0 or 180 degrees. `sigma`: of the arms, in any direction across them
/// [degrees].
Stated judged(const Stated& stated, double sigma) {
    const double near = std::max(kNearestDegrees, kNearestSigmas * sigma);
    if (stated.value < near)
        return asAtMost(stated, std::min(stated.value + kSigmas95 * sigma, 180.0), Limit::spread);
    if (180 - stated.value < near)
        return asAtLeast(stated, std::max(stated.value - kSigmas95 * sigma, 0.0), 180, Limit::spread);
    return stated;
}

Result<Stated> angleOf(const DrawnLine& first, const DrawnLine& second, const dmat3& projection, bool joined) {
    const Result<Arm> u = armOf(first, projection), v = armOf(second, projection);
    if (!u || !v)
        return !u ? u.error() : v.error();
    const double radians = std::atan2(glm::length(glm::cross(u->direction, v->direction)),  // exact near 0 and 180, too
                                      glm::dot(u->direction, v->direction));
    const dvec3 byFirst = turning(*u, *v), bySecond = turning(*v, *u);
    const std::array<Place, 4> places{first.to, second.to, first.from, second.from};
    // Where both lines begin in one place, its spread moves both.
    const std::array<dvec3, 4> gradients{byFirst * kDegrees, bySecond * kDegrees,
                                         (joined ? -byFirst - bySecond : -byFirst) * kDegrees,
                                         (joined ? dvec3(0) : -bySecond) * kDegrees};
    const double sigma = std::hypot(u->sigmaMm / u->lengthMm, v->sigmaMm / v->lengthMm) * kDegrees;
    return judged(propagated(radians * kDegrees, places, gradients, 0, 180), sigma);
}

}  // namespace

Result<Stated> angle(const Place& a, const Place& apex, const Place& b) {
    return angleOf({apex, a}, {apex, b}, dmat3(1), true);
}

Result<Stated> angleOfLines(const DrawnLine& first, const DrawnLine& second) {
    return angleOf(first, second, dmat3(1), false);
}

Result<Stated> angleInPlane(const DrawnLine& first, const DrawnLine& second, dvec3 normal) {
    return angleOf(first, second, dmat3(1) - glm::outerProduct(normal, normal), false);
}

Stated supplement(const Stated& angle) {
    Stated other = angle;
    other.value = 180 - angle.value;
    other.low = 180 - angle.high;
    other.high = 180 - angle.low;
    if (angle.bound != Bound::none)
        other.bound = angle.bound == Bound::atMost ? Bound::atLeast : Bound::atMost;
    return other;
}

}  // namespace pdr::measure
