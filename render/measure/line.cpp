#include "render/measure/line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pdr::measure {
namespace {

double trace(const dmat3& m) {
    return m[0][0] + m[1][1] + m[2][2];
}

}  // namespace

Line::Line(const Place& from, const Place& to)
    : lengthMm(glm::distance(from.mm, to.mm)),
      direction(lengthMm > 0 ? (to.mm - from.mm) / lengthMm : dvec3(1, 0, 0)),
      spread(from.spread.total() + to.spread.total()) {}

double varianceAcross(const dmat3& covariance, dvec3 direction) {
    return std::max(trace(covariance) - glm::dot(direction, covariance * direction), 0.0);
}

/// Solves the characteristic equation by the cosines of a third of an angle. Smith 1961, "Eigenvalues of a symmetric 3
/// x 3 matrix".
double largestVariance(const dmat3& covariance) {
    const double mean = trace(covariance) / 3;
    const dmat3 rest = covariance - mean * dmat3(1);
    const double scale = std::sqrt(trace(rest * rest) / 6);
    if (scale == 0)
        return mean;
    const double cosine = std::clamp(glm::determinant(rest / scale) / 2, -1.0, 1.0);
    return mean + 2 * scale * std::cos(std::acos(cosine) / 3);
}

}  // namespace pdr::measure
