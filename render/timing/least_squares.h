#pragma once
/// Weighted linear least squares in few unknowns, some of which must not be negative.

#include <array>
#include <optional>
#include <vector>

namespace pdr {

inline constexpr int kMostUnknowns = 4;

/// One equation: sum of factors[k] * unknown[k] = value.
struct Equation {
    std::array<double, kMostUnknowns> factors{};
    double value = 0;
    double weight = 1;  ///< 1 over the standard deviation of the value, up to a common factor; > 0
};

struct Solution {
    std::array<double, kMostUnknowns> unknowns{};  ///< 0 for those that are not used
    double squares = 0;                            ///< weighted sum of the squared residuals
    /// The unknowns' covariance where the weighted residuals have a variance of 1.
    std::array<std::array<double, kMostUnknowns>, kMostUnknowns> covariance{};
};

/// The unknowns whose bit is set in `used`; the others are 0. Nothing where the equations do not fix them.
std::optional<Solution> leastSquares(const std::vector<Equation>& equations, unsigned used);

/// The best with all unknowns >= 0: of all subsets of `used` the one with the least squares among those whose solution
/// is nowhere negative. (What is best under such bounds is best without bounds among the unknowns that are not 0.)
std::optional<Solution> nonNegativeLeastSquares(const std::vector<Equation>& equations, unsigned used);

}  // namespace pdr
