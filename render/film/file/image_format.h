#pragma once
/// The file formats in which images are saved.

#include <optional>

#include "render/base/file_ending.h"

namespace pdr {

enum class ImageFormat { png, exr };

/// Returns the format by the ending of the file name, in lower or upper case; nothing if the ending is neither.
inline std::optional<ImageFormat> imageFormat(const std::filesystem::path& file) {
    const std::string ending = fileEnding(file);
    return ending == ".png"   ? std::optional(ImageFormat::png)
           : ending == ".exr" ? std::optional(ImageFormat::exr)
                              : std::nullopt;
}

}  // namespace pdr
