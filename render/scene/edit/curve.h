#pragma once
/// A property of tissue against Hounsfield units: straight between points, as in a TransferFunction. Two points at the
/// same hu make a step, at which the right-hand one holds; outside the points the first or last one holds.

#include <cstddef>
#include <vector>

namespace pdr {

struct CurvePoint {
    float hu = 0;     ///< [kLowestHu, kHighestHu]
    float value = 0;  ///< in the property's own unit

    bool operator==(const CurvePoint&) const = default;
};

/// At least one point, ascending in hu.
using Curve = std::vector<CurvePoint>;
/// Points of a curve: indices, ascending.
using CurveSelection = std::vector<std::size_t>;

inline constexpr float kLowestHu = -32768, kHighestHu = 32767;

/// By the rules above.
float valueAt(const Curve& curve, float hu);

/// The largest value.
float heightOf(const Curve& curve);

/// The first hu at which the curve has come to `value`, the last point's where it never does.
float firstAt(const Curve& curve, float value);

/// `curve` with one point more, behind those of the same hu; returns where it stands.
std::size_t insertPoint(Curve& curve, const CurvePoint& point);

/// `curve` with the selected points moved, each as far in value as [0, top] lets it. In hu they move as one, up to the
/// points that stay where they are, which they never pass: there they make a step.
Curve moved(Curve curve, const CurveSelection& selection, CurvePoint by, float top);

/// `curve` without the selected points. One remains: the first.
Curve without(const Curve& curve, const CurveSelection& selection);

/// The larger of both curves everywhere.
Curve larger(const Curve& a, const Curve& b);

}  // namespace pdr
