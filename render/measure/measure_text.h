#pragma once
/// Measured values as users read them.

#include "render/base/text.h"
#include "render/measure/region_statistics.h"
#include "render/measure/stated.h"
#include "render/volume/value_unit.h"

namespace pdr::measure {

/// What a value is measured in; `hu` stands for the unit of the scan's values.
enum class Unit { mm, degrees, mm2, hu };

/// A number and its ± with as many decimals as the ± has reasons for: one significant digit of it, two if the first is
/// a one. A ± is rounded up, and is nowhere below `least`: what is not in it is larger than that.
struct RoundedPlusMinus {
    double plusMinus;
    int decimals;  ///< for the value, too; negative: tens, hundreds
};
RoundedPlusMinus roundedPlusMinus(double plusMinus, double least = 0.1);

/// Returns a value with its ±: "42.3 ± 0.5 mm", "at most 2.9 mm: thinner than this scan can tell", "at least 176°". A
/// value of typed places, which has no ±, is given to 0.1.
Text valueText(const Stated& stated, Unit unit);

/// Returns what the ± consists of, largest first, and what is not in it: "Grid ±0.4, edges ±0.2, hand ±0.2. Not in it:
/// the scanner's own scale, movement, what was meant."
Text causesText(const Stated& stated);

/// Returns the statistics of voxels as those of the values that they stand for.
RegionStatistics inValues(RegionStatistics statistics, const ValueUnit& unit);

/// Returns a mean with its ±: "55 ± 11 HU", or "55 HU, too few voxels for a ±". `statistics`: of values in `unit`.
Text meanText(const RegionStatistics& statistics, const ValueUnit& unit = {});

/// Returns what else is known of a region: its SD, median and extremes, voxels and volume, what was left out, and what
/// its ± is. `statistics`: of values in `unit`.
Text regionText(const RegionStatistics& statistics, const ValueUnit& unit = {});

}  // namespace pdr::measure
