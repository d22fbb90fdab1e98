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
    std::array<double, kMostUnknowns> unknowns{};  ///< 0 for unknowns that are not used
    double squares = 0;                            ///< weighted sum of the squared residuals
    /// Covariance of the unknowns if the weighted residuals have a variance of 1.
    std::array<std::array<double, kMostUnknowns>, kMostUnknowns> covariance{};
};

/// Solves for the unknowns whose bit is set in `used`; the others are 0. Returns nothing if the equations do not
/// determine them.
std::optional<Solution> leastSquares(const std::vector<Equation>& equations, unsigned used);

/// Returns the best solution with all unknowns >= 0: of all subsets of `used`, the one with the least squares among
/// those whose solution is nowhere negative. (The best solution under such bounds is the best without bounds in the
/// unknowns that are not 0.)
std::optional<Solution> nonNegativeLeastSquares(const std::vector<Equation>& equations, unsigned used);

}  // namespace pdr
