#include "render/scene/range.h"

#include <cmath>
#include <sstream>

namespace pdr {

bool Range::holds(double value) const {
    return std::isfinite(value) && (lowestIncluded ? value >= lowest : value > lowest) &&
           (highestIncluded ? value <= highest : value < highest);
}

Text Range::text() const {
    // Limits are round numbers; as a float one may be a little off.
    const Text low = numberOf(lowest), high = numberOf(highest);
    if (lowestIncluded && highestIncluded)
        return phrase("from %1 to %2", low, high);
    if (!lowestIncluded && !highestIncluded)
        return phrase("above %1 and below %2", low, high);
    return phrase(lowestIncluded ? "at least %1 and below %2" : "above %1 and at most %2", low, high);
}

std::string numberText(double value, int digits) {
    std::ostringstream out;
    out.precision(digits);
    out << value;
    return out.str();
}

Result<void> checkRange(double value, const Range& range, const std::string& where) {
    if (range.holds(value))
        return {};
    return Error{phrase("is %1, must be %2", Text::number(numberText(value)), range.text()), where, "",
                 ErrorKind::refused};
}

Result<void> checkRange(dvec3 value, const Range& range, const std::string& where) {
    for (int i = 0; i < 3; ++i)
        if (!range.holds(value[i]))
            return Error{phrase("holds %1, each number must be %2", Text::number(numberText(value[i])), range.text()),
                         where, "", ErrorKind::refused};
    return {};
}

Result<void> checkDirection(dvec3 value, const std::string& where) {
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(value[i]))
            return Error{phrase("is no direction: it needs three finite numbers"), where, ""};
    if (value == dvec3(0))
        return Error{phrase("is no direction: it has no length"), where, ""};
    const double length = glm::length(value);
    if (length >= 1e-100 && length <= 1e100)  // outside, its square is not a number to divide by
        return {};
    return Error{phrase("is no direction: its length must be from 1e-100 to 1e+100"), where, ""};
}

Error below(const std::string& parent, Error error) {
    const bool both = !parent.empty() && !error.where.empty();
    error.where = parent + (both ? "." : "") + error.where;
    return error;
}

}  // namespace pdr
