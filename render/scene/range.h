#pragma once
/// The range of a field, and the error text for a value outside it.

#include <string>

#include "render/base/portable.h"
#include "render/base/result.h"

namespace pdr {

/// The values that a field may have. NaN and the infinities are always outside.
struct Range {
    double lowest = 0;
    double highest = 0;
    bool lowestIncluded = true;
    bool highestIncluded = true;

    bool holds(double value) const;
    Text text() const;  ///< "from 0 to 1e+30", "above -1 and below 1"
};

/// Formats a number as a person would write it: "0.5", "1e+30".
std::string numberText(double value, int digits = 9);

/// Checks that `value` lies in `range`; an error names the field `where`.
Result<void> checkRange(double value, const Range& range, const std::string& where);
/// Checks each of three channels or coordinates; an error names the field `where`.
Result<void> checkRange(dvec3 value, const Range& range, const std::string& where);
/// Checks that `value` is a direction: three finite numbers, and a length from 1e-100 to 1e100.
Result<void> checkDirection(dvec3 value, const std::string& where);

/// Returns `error` with its field's name put below `parent`: "lights[1]" and "radiance" become "lights[1].radiance".
Error below(const std::string& parent, Error error);

}  // namespace pdr
