#pragma once
/// Finds files that should have been slices, and the series that may lack them.

#include <filesystem>
#include <vector>

#include "dicom/read/slice_header.h"
#include "dicom/series_source.h"

namespace pdr::dicom {

/// Returns those of `foreign`, files of `source` that are not DICOM, that may be broken copies of slices: they lie in a
/// folder with `slices` and are empty, or are named like the slices there except for numbers ("IM0007" beside
/// "IM0006"), or have their ending (".dcm"). Hidden files are left out.
std::vector<Problem> spoiltFiles(const SeriesSource& source, const std::vector<std::filesystem::path>& foreign,
                                 const std::vector<SliceHeader>& slices);

/// Adds notes to the CT series in `all` about the `damaged` files and folders that they may lack. A file that states
/// its series is noted there. One that does not is noted on all series whose slices lie in its folder or below, and if
/// there is none, on all. Names in notes are relative to `root`.
void noteDamaged(const std::vector<SliceHeader>& damaged, const std::filesystem::path& root, std::vector<Series>& all);

}  // namespace pdr::dicom
