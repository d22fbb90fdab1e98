#pragma once
/// The unit of a volume file's values, which such files hardly ever state.

#include "render/volume/file/grid_file.h"
#include "render/volume/value_unit.h"

namespace pdr::app {

/// Values from the lowest to the highest; what is not a number is left out.
struct ValueRange {
    double lowest = 0, highest = 0;
    bool areWhole = true;  ///< whether all are whole numbers
};

/// Returns whether values may be HU: the lowest in [-32768, -100], which fat and air have, and the highest in [100,
/// 32767], which bone and contrast have. Images of 0 to 255, stored values from 0 on, MR and labels are none.
bool mayBeHu(const ValueRange& range);

/// Returns the unit of the voxels of values in `range`, which is finite, as they lie in `grid`. Of values that are no
/// HU, a voxel is the value itself, or else the sample, shifted into 16 bits where that needs it: no value is rounded
/// then. Where both span more than 16 bits, or are fractions, the 65,536 steps of a voxel span the range.
ValueUnit gridUnit(const GridFile& grid, const ValueRange& range);

/// Returns whether voxels of `unit` stand for values of `grid` exactly.
bool isExact(const GridFile& grid, const ValueUnit& unit, const ValueRange& range);

}  // namespace pdr::app
