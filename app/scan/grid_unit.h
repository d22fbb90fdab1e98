#pragma once
/// The unit of a volume file's values, which such files hardly ever state.

#include "render/volume/file/grid_file.h"
#include "render/volume/value_unit.h"

namespace pdr::app {

/// Returns whether values may be HU: the lowest in [-32768, -100], which fat and air have, and the highest in [100,
/// 32767], which bone and contrast have. Images of 0 to 255, stored values from 0 on, MR and labels are none.
bool mayBeHu(const ValueRange& range);

/// Returns the unit of the voxels of values in `range`, which is finite, as they lie in `grid`: HU if they may be.
/// Steps that are known are those of samples that are whole numbers; see fittedUnit().
FittedUnit gridUnit(const GridFile& grid, const ValueRange& range);

}  // namespace pdr::app
