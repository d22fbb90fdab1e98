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

}  // namespace

bool mayBeHu(const ValueRange& range) {
    constexpr double kFat = -100, kBone = 100;
    return range.lowest >= INT16_MIN && range.lowest <= kFat && range.highest >= kBone && range.highest <= INT16_MAX;
}

FittedUnit gridUnit(const GridFile& grid, const ValueRange& range) {
    if (mayBeHu(range) && canBeBelowZero(grid))
        return {};
    return fittedUnit({}, range, areWhole(grid.type) ? ValueSteps{std::abs(grid.slope), grid.intercept} : ValueSteps());
}

}  // namespace pdr::app
