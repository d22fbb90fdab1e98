#pragma once
/// Angles [degrees, 0 to 180].

#include "render/base/result.h"
#include "render/measure/stated.h"

namespace pdr::measure {

/// The ends of a line, in the order in which they were drawn.
struct DrawnLine {
    Place from, to;
};

/// Returns the angle at `apex` between the places `a` and `b`. Near 0 and 180 degrees, where spread can only open or
/// close it, it is a bound: within 5 degrees, or three standard deviations. Fails if an arm is no longer than three
/// times the spread of its ends; where that is the light's fault, the error names the place that is less sure, in the
/// order of the parameters.
Result<Stated> angle(const Place& a, const Place& apex, const Place& b);

/// Returns the angle between two lines in space as they were drawn, by the rules of angle().
Result<Stated> angleOfLines(const DrawnLine& first, const DrawnLine& second);

/// Returns the angle between two lines as they appear in the plane with the unit normal `normal`, by the rules of
/// angle().
Result<Stated> angleInPlane(const DrawnLine& first, const DrawnLine& second, dvec3 normal);

/// Returns 180 degrees less an angle: what two lines form on their other side.
Stated supplement(const Stated& angle);

}  // namespace pdr::measure
