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

/// Which places of a measurement the ends of a line are, in the order in which they were set, from 0.
struct Order {
    int from, to;
};

Text isKnownTo(int place, const Text& plusMinus) {
    switch (place) {
        case 0:
            return phrase("the first place is known only to ± %1 mm", plusMinus);
        case 1:
            return phrase("the second place is known only to ± %1 mm", plusMinus);
        case 2:
            return phrase("the third place is known only to ± %1 mm", plusMinus);
        default:
            return phrase("the fourth place is known only to ± %1 mm", plusMinus);
    }
}

/// Returns why a line has no direction though its ends lie far apart: light leaves open how deep the end lies that is
/// less sure.
Error unsureEnd(const DrawnLine& line, const Order& order) {
    const double from = largestVariance(line.from.spread.total()), to = largestVariance(line.to.spread.total());
    const Text plusMinus = fixedNumber(std::ceil(kSigmas95 * std::sqrt(std::max(from, to))), 0);
    return {isKnownTo(from > to ? order.from : order.to, plusMinus), "",
            phrase("It was seen through translucent tissue. Drag it to where it belongs on a slice."),
            ErrorKind::refused};
}

/// Returns the arm between two places, projected by `projection`.
Result<Arm> armOf(const DrawnLine& line, const dmat3& projection, const Order& order) {
    const dvec3 reach = projection * (line.to.mm - line.from.mm);
    const double length = glm::length(reach);
    const dvec3 direction = length > 0 ? reach / length : dvec3(0);
    const auto sigmaAcross = [&](const dmat3& spread) {
        return std::sqrt(varianceAcross(projection * spread * projection, direction));
    };
    const dmat3 spread = line.from.spread.total() + line.to.spread.total();
    const dmat3 byLight = line.from.spread.of(Cause::light) + line.to.spread.of(Cause::light);
    const Arm arm{direction, length, sigmaAcross(spread)};
    if (length > kShortestSpreads * arm.sigmaMm)
        return arm;
    if (length > kShortestSpreads * sigmaAcross(spread - byLight))
        return unsureEnd(line, order);
    return Error{phrase("a line is too short to have a direction"), "", phrase("Put its ends farther apart."),
                 ErrorKind::refused};
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

/// Returns the angle of two lines. `joined`: both begin in one place, the second of three.
Result<Stated> angleOf(const DrawnLine& first, const DrawnLine& second, const dmat3& projection, bool joined) {
    const Result<Arm> u = armOf(first, projection, joined ? Order{1, 0} : Order{0, 1}),
                      v = armOf(second, projection, joined ? Order{1, 2} : Order{2, 3});
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
