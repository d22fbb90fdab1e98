#pragma once
/// How much larger the error that denoised images state is than their true error.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace pdr::test {

/// Returns the value that `fraction` of the values do not exceed; 0 without values.
inline double quantile(std::vector<double> values, double fraction) {
    if (values.empty())
        return 0;
    const auto at = values.begin() + std::ptrdiff_t(fraction * double(values.size() - 1));
    std::ranges::nth_element(values, at);
    return *at;
}

/// The stated and the true errors of the images of one scene and number of samples.
class Slack {
  public:
    /// Adds an image that states `stated` levels for 95 % of its pixels, which are `off` levels from the truth.
    /// `truthNoise`: mean square of the truth's own noise [levels²], by which the image seems worse than it is.
    void add(double stated, const std::vector<double>& off, double truthNoise) {
        double squares = 0;
        for (const double one : off)
            squares += one * one / double(off.size());
        if (squares > truthNoise)
            ratios_.push_back(stated / (quantile(off, 0.95) * std::sqrt(1 - truthNoise / squares)));
    }
    /// Returns the median of stated over true; nothing without an image that states its error.
    std::optional<double> median() const {
        return ratios_.empty() ? std::nullopt : std::optional(quantile(ratios_, 0.5));
    }

  private:
    std::vector<double> ratios_;
};

}  // namespace pdr::test
