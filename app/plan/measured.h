#pragma once
/// What a measurement says of its scan: a value with its ±, and the texts in which users read it.

#include <optional>

#include "app/plan/measurement.h"
#include "render/base/result.h"
#include "render/measure/measure_text.h"

namespace pdr::app {

struct Measured {
    measure::Unit unit = measure::Unit::mm;
    ValueUnit valueUnit;              ///< unit of the scan's values, that of Unit::hu and of a region's figures
    double value = 0;                 ///< in `unit`; of a bound, the bound
    std::optional<double> plusMinus;  ///< half of the 95 % interval, unrounded; none: a bound, typed places, the HU of
                                      ///< a single place, too few voxels
    measure::Bound bound = measure::Bound::none;
    std::optional<measure::RegionStatistics> region;  ///< the voxels of a region, as values
    std::optional<measure::Stated> area;              ///< area of an ellipse or a polygon [mm^2]
    bool acrossHole = false;                          ///< depends on slices that were not measured (hole_mark.h)
    Text text;                                        ///< the value as lists and views show it: "42.3 ± 0.5 mm"
    Text details;                                     ///< sentences: what the ± consists of, and what else is known
};

/// Returns half of the 95 % interval of a value; none: it has no ±, or is a bound.
std::optional<double> plusMinusOf(const measure::Stated& stated);

/// Returns what `measurement`, which has the places of its kind, says of `volume`. Fails if the places do not measure
/// anything: the ends of an angle's line are too close to each other, or not known well enough, a place lies where the
/// scanner measured nothing, a region holds no voxel, or more than kMostRegionVoxels.
Result<Measured> measured(const Measurement& measurement, const Volume& volume);

/// Returns what a measurement without a name is called: "Distance 2". `number` counts those of its kind from 1.
Text ordinalName(MeasureKind kind, int number);

/// Most voxels whose statistics are computed, which takes 0.1 to 0.3 s: a ball of 9 cm across on 0.9 x 0.9 x 2.5 mm.
inline constexpr double kMostRegionVoxels = 200'000;

}  // namespace pdr::app
