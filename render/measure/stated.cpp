#include "render/measure/stated.h"

#include <algorithm>
#include <cmath>

namespace pdr::measure {

double Stated::plusMinus() const {
    double squares = 0;
    for (const double each : shares)
        squares += each * each;
    return std::sqrt(squares);
}

Stated propagated(double value, std::span<const Place> places, std::span<const dvec3> gradients, double lowest,
                  double highest) {
    Stated stated{.value = value};
    for (std::size_t cause = 0; cause < kCauses; ++cause) {
        double variance = 0;
        for (std::size_t n = 0; n < places.size(); ++n)
            variance += glm::dot(gradients[n], places[n].spread.mm2[cause] * gradients[n]);
        stated.shares[cause] = kSigmas95 * std::sqrt(std::max(variance, 0.0));
    }
    stated.low = std::max(value - stated.plusMinus(), lowest);
    stated.high = std::min(value + stated.plusMinus(), highest);
    return stated;
}

Stated asAtMost(Stated stated, double value, Limit limit) {
    stated.value = stated.high = value;
    stated.low = 0;
    stated.bound = Bound::atMost;
    stated.limit = limit;
    return stated;
}

Stated asAtLeast(Stated stated, double value, double highest, Limit limit) {
    stated.value = stated.low = value;
    stated.high = highest;
    stated.bound = Bound::atLeast;
    stated.limit = limit;
    return stated;
}

}  // namespace pdr::measure
