#pragma once
/// Multi-frame images that were stored in several files (a concatenation, PS3.3, C.7.6.16.2.2.4).

#include <vector>

#include "dicom/read/slice_header.h"
#include "render/base/text.h"

namespace pdr::dicom {

/// Returns a phrase that names the first part of a concatenation that is not among `slices`, which are of one series;
/// empty if all are there, or none of the slices belongs to one. Where no file states the number of parts, the last one
/// that is there is taken for the last.
Text missingPart(const std::vector<const SliceHeader*>& slices);

}  // namespace pdr::dicom
