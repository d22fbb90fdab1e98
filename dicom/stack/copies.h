#pragma once
/// Slices that lie at one place because one is a copy of the other.

#include <vector>

#include "dicom/read/slice_header.h"
#include "dicom/series_source.h"
#include "dicom/stack/stack_geometry.h"
#include "render/base/progress.h"

namespace pdr::dicom {

/// Judges the stack of `headers`, which share a grid and come from `source`; takes copies of slices out of them first,
/// and notes them. None is taken out if any slice at the place of another is no copy of it.
StackAnalysis analyseWithoutCopies(std::vector<const SliceHeader*>& headers, const SeriesSource& source,
                                   const Progress& progress);

}  // namespace pdr::dicom
