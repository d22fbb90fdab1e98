#pragma once
/// What a user should know about slices that load all the same.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "dicom/read/slice_header.h"

namespace pdr::dicom {

/// `slices` of one even stack, ascending along its normal. `numbers`: the instance numbers of all files of the series,
/// whatever became of them.
std::vector<Note> notesOn(const std::vector<const SliceHeader*>& slices, const std::set<int>& numbers);

/// "a.dcm, b.dcm, c.dcm ...": the first three, and a sign that there are more.
std::string listed(const std::vector<std::string>& names);

/// The name of `file` as seen from `root`.
std::string shortName(const std::filesystem::path& file, const std::filesystem::path& root);

}  // namespace pdr::dicom
