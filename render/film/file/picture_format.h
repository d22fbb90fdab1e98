#pragma once
/// The formats that images are saved in.

#include <optional>

#include "render/base/file_ending.h"

namespace pdr {

enum class PictureFormat { png, exr };

/// By the ending of the name, in small letters or capitals; nothing where it says neither.
inline std::optional<PictureFormat> pictureFormat(const std::filesystem::path& file) {
    const std::string ending = fileEnding(file);
    return ending == ".png"   ? std::optional(PictureFormat::png)
           : ending == ".exr" ? std::optional(PictureFormat::exr)
                              : std::nullopt;
}

}  // namespace pdr
