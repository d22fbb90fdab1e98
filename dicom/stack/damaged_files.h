#pragma once
/// Files that should have been slices, and the series that may lack them.

#include <filesystem>
#include <vector>

#include "dicom/read/slice_header.h"

namespace pdr::dicom {

/// Those of `foreign`, files that are no DICOM, which a broken copy may have left of a slice: they lie in a folder with
/// `slices` and are empty, or are called as the slices there but for their numbers ("IM0007" beside "IM0006") or end as
/// they do (".dcm"). Hidden files are none of them.
std::vector<Problem> spoiltFiles(const std::vector<std::filesystem::path>& foreign,
                                 const std::vector<SliceHeader>& slices);

/// Notes on the series of CT in `all` which of the `damaged` files and folders they may lack. What says its series is
/// noted there; what does not, on all series whose slices lie in its folder or below, and where there is none, on all.
/// Names in notes are relative to `root`.
void noteDamaged(const std::vector<SliceHeader>& damaged, const std::filesystem::path& root, std::vector<Series>& all);

}  // namespace pdr::dicom
