#pragma once
/// Groups the headers of many files into series, with a verdict on each.

#include <memory>
#include <vector>

#include "dicom/read/slice_header.h"
#include "dicom/series_source.h"
#include "render/base/progress.h"

namespace pdr::dicom {

/// Sorts `headers` into series and judges each. Slices of one series that cannot share a grid become entries of their
/// own with the same facts; so do colour images, localizers and the like. `damaged` are files and folders that could
/// not be used, with what could be read of their headers. The series they belong to carries a note; those that state no
/// series are noted on all whose slices lie in the same folder, or else on all. Names in messages are relative to
/// the root of `source`. Reads pixels only of slices that lie at the same position, to tell copies from conflicts.
std::vector<Series> groupIntoSeries(const std::vector<SliceHeader>& headers, const std::vector<SliceHeader>& damaged,
                                    const std::shared_ptr<const SeriesSource>& source, const Progress& progress);

}  // namespace pdr::dicom
