#pragma once
/// The files that hold a whole scan, by their endings. Any other file of a scan lies in a folder with its like.

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

#include "render/base/file_ending.h"

namespace pdr {

/// Endings of archives and volume files, for a dialog's filter.
inline constexpr std::array kScanEndings{".zip", ".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd"};

/// Returns the one of kScanEndings, in any case, with which the name of `file` ends; empty if there is none.
inline std::string scanEnding(const std::filesystem::path& file) {
    const std::string last = fileEnding(file);
    const std::string ending = last == ".gz" ? fileEnding(file.stem()) + last : last;
    return std::ranges::find(kScanEndings, ending) == kScanEndings.end() ? std::string() : ending;
}

}  // namespace pdr
