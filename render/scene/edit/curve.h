#pragma once
/// A property of tissue against Hounsfield units: linear between points, as in a TransferFunction. Two points at the
/// same hu make a step, at which the right-hand one applies; outside the points the first or last one applies.

#include <cstddef>
#include <vector>

namespace pdr {

struct CurvePoint {
    float hu = 0;     ///< [kLowestHu, kHighestHu]
    float value = 0;  ///< in the property's own unit

    bool operator==(const CurvePoint&) const = default;
};

/// A curve: at least one point, ascending in hu.
using Curve = std::vector<CurvePoint>;
/// Selected points of a curve: indices, ascending.
using CurveSelection = std::vector<std::size_t>;

inline constexpr float kLowestHu = -32768, kHighestHu = 32767;

/// Returns the value at `hu`, by the rules above.
float valueAt(const Curve& curve, float hu);

/// Returns the largest value.
float heightOf(const Curve& curve);

/// Returns the first hu at which the curve reaches `value`; the last point's hu if it never does.
float firstAt(const Curve& curve, float value);

/// Inserts a point into `curve`, behind those of the same hu; returns its index.
std::size_t insertPoint(Curve& curve, const CurvePoint& point);

/// Returns `curve` with the selected points moved by `by`. Each moves in value as far as [0, top] allows. In hu they
/// move as one, up to the points that stay, which they never pass: there they make a step.
Curve moved(Curve curve, const CurveSelection& selection, CurvePoint by, float top);

/// Returns `curve` without the selected points. If all are selected, the first remains.
Curve without(const Curve& curve, const CurveSelection& selection);

/// Returns the larger of both curves everywhere.
Curve larger(const Curve& a, const Curve& b);

}  // namespace pdr
