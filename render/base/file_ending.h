#pragma once
/// The ending of a file's name, which states its format.

#include <filesystem>
#include <string>

#include "render/base/lower_case.h"

namespace pdr {

/// Returns the ending of a file's name in lower case (a to z), ".png" for "head.PNG"; empty if there is none.
inline std::string fileEnding(const std::filesystem::path& file) {
    return lowerCase(file.extension().string());
}

}  // namespace pdr
