#pragma once
/// The unit that the slices of one series have in common, and how their stored numbers become its voxels.

#include <string_view>
#include <vector>

#include "dicom/read/slice_header.h"
#include "render/volume/value_unit.h"

namespace pdr::dicom {

/// The code of the note that values are no HU. A volume's remarks have unitWord() in its place.
inline constexpr std::string_view kNoHu = "no-hu";

/// Returns the unit of the voxels of `slices`: HU if all of them are. Otherwise a voxel is the value itself if all that
/// can be stored are whole numbers of 16 bits; else the stored number, shifted into 16 bits where that needs it, if one
/// slope and intercept hold for all slices: no value is rounded then. If they differ, the 65,536 steps of a voxel span
/// all values that the slices can state.
ValueUnit seriesUnit(const std::vector<const SliceHeader*>& slices);

/// Adds a note that the values are no HU, and one where they are rounded to steps of `unit`, that of `slices`.
void noteUnit(const std::vector<const SliceHeader*>& slices, const ValueUnit& unit, std::vector<Note>& notes);

}  // namespace pdr::dicom
