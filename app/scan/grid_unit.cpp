#include "app/scan/grid_unit.h"

#include <cmath>

namespace pdr::app {
namespace {

/// Returns whether the samples can stand for negative values.
bool canBeBelowZero(const GridFile& grid) {
    const bool isUnsigned = grid.type == SampleType::uint8 || grid.type == SampleType::uint16 ||
                            grid.type == SampleType::uint32 || grid.type == SampleType::uint64;
    return !isUnsigned || grid.slope < 0 || grid.intercept < 0;
}

bool areWhole(SampleType type) {
    return type != SampleType::float32 && type != SampleType::float64;
}

/// Returns the steps that all values are whole multiples of, counted from `zero`; 0: none is known.
double stepOf(const GridFile& grid, const ValueRange& range, double& zero) {
    zero = 0;
    if (range.areWhole)
        return 1;
    zero = grid.intercept;
    return areWhole(grid.type) ? std::abs(grid.slope) : 0;
}

/// Returns how far voxels must move to lie within 16 bits.
double shiftOf(double lowest, double highest) {
    constexpr double kTremble = 1e-6;  // of quotients that are whole numbers
    if (highest > INT16_MAX)
        return std::ceil(highest - INT16_MAX - kTremble);
    return lowest < INT16_MIN ? std::floor(lowest - INT16_MIN + kTremble) : 0;
}

}  // namespace

bool mayBeHu(const ValueRange& range) {
    constexpr double kFat = -100, kBone = 100;
    return range.lowest >= INT16_MIN && range.lowest <= kFat && range.highest >= kBone && range.highest <= INT16_MAX;
}

ValueUnit gridUnit(const GridFile& grid, const ValueRange& range) {
    if (mayBeHu(range) && canBeBelowZero(grid))
        return {};
    double zero = 0;
    const double step = stepOf(grid, range, zero), span = range.highest - range.lowest;
    if (step > 0 && span <= step * UINT16_MAX)
        return ValueUnit::other({}, step,
                                zero + step * shiftOf((range.lowest - zero) / step, (range.highest - zero) / step));
    const double coarse = span > 0 ? span / UINT16_MAX : 1;
    return ValueUnit::other({}, coarse, range.lowest - coarse * INT16_MIN);
}

bool isExact(const GridFile& grid, const ValueUnit& unit, const ValueRange& range) {
    double zero = 0;
    return unit.step == stepOf(grid, range, zero);
}

}  // namespace pdr::app
