#pragma once
/// A measured value with what is known of its error: the linear propagation of the spread of places (JCGM 100:2008,
/// 5.1.2), in the unit of the value.

#include <span>

#include "render/measure/place.h"

namespace pdr::measure {

/// Half of a 95 % interval, in standard deviations.
inline constexpr double kSigmas95 = 1.96;

/// What a value says about the truth.
enum class Bound {
    none,     ///< it estimates the truth
    atMost,   ///< the truth is not larger
    atLeast,  ///< the truth is not smaller
};

/// Why a value is only a bound.
enum class Limit {
    none,
    thin,    ///< two edges are so close that the scan blurs them into one
    spread,  ///< the places are not sure enough
};

struct Stated {
    double value = 0;
    double low = 0, high = 0;  ///< 95 % interval; of a bound, from or to the end of what is possible
    Bound bound = Bound::none;
    Limit limit = Limit::none;
    /// Half of the 95 % interval that each cause would have alone; the squares add up to the square of plusMinus().
    std::array<double, kCauses> shares{};

    double share(Cause cause) const { return shares[std::size_t(cause)]; }
    /// Returns half of the 95 % interval before it was cut at the end of what is possible. Without meaning for a bound.
    double plusMinus() const;
};

/// Returns what is known of `value`, whose derivative with respect to place n is gradients[n] [unit/mm]. The interval
/// is cut at the ends of [lowest, highest].
Stated propagated(double value, std::span<const Place> places, std::span<const dvec3> gradients, double lowest,
                  double highest);

/// Return the bound that `stated` leaves when it is no estimate: from 0 to `value`, or from `value` to `highest`.
Stated asAtMost(Stated stated, double value, Limit limit);
Stated asAtLeast(Stated stated, double value, double highest, Limit limit);

}  // namespace pdr::measure
