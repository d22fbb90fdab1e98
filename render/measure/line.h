#pragma once
/// A straight line from one place to another and how its ends spread.

#include "render/measure/place.h"

namespace pdr::measure {

/// Returns the sum of the variances in the two directions across the unit vector `direction`. `covariance` is
/// symmetric.
double varianceAcross(const dmat3& covariance, dvec3 direction);

struct Line {
    double lengthMm;
    dvec3 direction;  ///< unit vector from the first place to the second; +x where the two are the same
    dmat3 spread;     ///< covariance of the difference of the two places [mm^2]

    Line(const Place& from, const Place& to);

    /// Returns the sum of the variances in the two directions across the line [mm^2].
    double varianceAcross() const { return measure::varianceAcross(spread, direction); }
    /// Returns by how much spread across the line lengthens it on average, to second order [mm]. Needs a length > 0.
    double lengtheningMm() const { return varianceAcross() / (2 * lengthMm); }
};

/// Returns the variance along the direction in which a symmetric covariance is largest.
double largestVariance(const dmat3& covariance);

}  // namespace pdr::measure
