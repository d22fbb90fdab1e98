#pragma once
/// The unit that the slices of one series have in common, and how their stored numbers become its voxels.

#include <string_view>
#include <vector>

#include "dicom/read/slice_header.h"
#include "render/volume/value_unit.h"

namespace pdr::dicom {

/// The code of the note that values are no HU. A volume's remarks have unitWord() in its place.
inline constexpr std::string_view kNoHu = "no-hu";

/// Returns the unit of the voxels of `slices`, whose values lie in `range` (value_range.h): HU if all of them are, else
/// fitted to the range (fittedUnit()). The steps of values that slices of one slope and intercept store as whole
/// numbers are known.
FittedUnit seriesUnit(const std::vector<const SliceHeader*>& slices, const ValueRange& range);

/// Returns the note that values are rounded to steps of `unit`.
Note roundingNote(const ValueUnit& unit);

/// Adds a note that the values are no HU, and one where they are rounded to steps of their unit, that of `slices`.
void noteUnit(const std::vector<const SliceHeader*>& slices, const FittedUnit& unit, std::vector<Note>& notes);

}  // namespace pdr::dicom
