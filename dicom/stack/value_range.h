#pragma once
/// The range of the values of slices that are no HU, to which their unit is fitted.

#include <vector>

#include "dicom/read/slice_header.h"
#include "dicom/series_source.h"
#include "render/base/progress.h"
#include "render/volume/value_unit.h"

namespace pdr::dicom {

/// Returns the values that pixels of the formats of `slices` can state.
ValueRange possibleValues(const std::vector<const SliceHeader*>& slices);

/// Returns the range that holds the values of `slices`, which come from `source`: what can be stated, or, of
/// floating-point numbers and pixels of more than 16 bits, what is stated. Those are read for it, on all cores, unless
/// they are HU; a slice that cannot be read is left out. Of no use if `progress` requests a stop.
ValueRange valueRange(const std::vector<const SliceHeader*>& slices, const SeriesSource& source,
                      const Progress& progress);

}  // namespace pdr::dicom
