#pragma once
/// A row of a table that says whether stated intervals hold the truth.

#include <cmath>
#include <cstdio>
#include <optional>

#include "render/measure/measure_text.h"
#include "tests/support/statistics.h"

namespace pdr::test {

/// Returns `part` in percent of `whole`; not a number if that is 0.
inline double percent(int part, int whole) {
    return whole > 0 ? 100.0 * part / whole : NAN;
}

/// What became of the trials of a row: how many were stated, a bound, or lost; stated intervals and bounds that hold;
/// stated values that are farther off than the ± that is printed.
struct CoverageRow {
    int stated = 0, bounds = 0, lost = 0, held = 0, heldBounds = 0, untold = 0;
    Sample value, variance;

    void add(const std::optional<measure::Stated>& found, double truth) {
        if (!found)
            return void(++lost);
        if (found->bound != measure::Bound::none) {
            ++bounds;
            heldBounds += found->low <= truth && truth <= found->high;
            return;
        }
        ++stated;
        held += found->low <= truth && truth <= found->high;
        value.add(found->value - truth);
        variance.add(std::pow(found->plusMinus() / 1.96, 2));
        untold += std::abs(found->value - truth) > measure::roundedPlusMinus(found->plusMinus()).plusMinus;
    }
    void print() const {
        std::printf("%6d %7d %7d ", stated, bounds, lost);
        if (stated > 1)
            std::printf("%+6.3f %6.3f %6.3f %6.1f ", value.mean(), std::sqrt(value.variance()),
                        std::sqrt(variance.mean()), percent(held, stated));
        else
            std::printf("%6s %6s %6s %6s ", "", "", "", "");
        std::printf("%6.1f %6d\n", percent(heldBounds, bounds), untold);
        std::fflush(stdout);
    }
};

}  // namespace pdr::test
