#pragma once
/// Notes for the user about slices that can be loaded all the same.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "dicom/read/slice_header.h"
#include "dicom/stack/slice_plane.h"
#include "render/volume/value_unit.h"

namespace pdr::dicom {

/// Returns notes on the `slices` of one even stack, ascending along its normal, with the unit of their values.
/// `numbers`: the instance numbers of all files of the series, usable or not.
std::vector<Note> notesOn(const std::vector<const SliceHeader*>& slices, const FittedUnit& unit,
                          const std::set<int>& numbers);

/// Joins names: "a.dcm, b.dcm, c.dcm ...": the first three, and a sign that there are more.
std::string listed(const std::vector<std::string>& names);

/// Returns what messages call a slice: the name of its file as seen from `root`, and behind it the number of its frame,
/// from 1, if the file holds several: "thorax.dcm #12".
std::string sliceName(const SliceHeader& slice, const std::filesystem::path& root);

/// Returns the places of slices, each called by its sliceName().
std::vector<SlicePlane> planesOf(const std::vector<const SliceHeader*>& headers, const std::filesystem::path& root);

/// Returns the name of `file` as seen from `root`.
std::string shortName(const std::filesystem::path& file, const std::filesystem::path& root);

}  // namespace pdr::dicom
