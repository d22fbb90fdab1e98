#pragma once
/// Images that are no film, such as slices, saved to disk. What image_file.h says of privacy, modes and errors holds
/// for them, too.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "render/base/portable.h"
#include "render/base/result.h"
#include "render/film/file/provenance.h"

namespace pdr {

/// Writes an 8-bit sRGB PNG with the facts as text chunks. `rgba`: 4 bytes a pixel, row by row from the top.
Result<void> writePng(ivec2 size, std::vector<std::uint8_t>& rgba, const std::vector<Fact>& facts,
                      const std::filesystem::path& path);

/// One number for every pixel, row by row from the top; NaN where there is none.
struct ValueChannel {
    std::string name;     ///< name of the channel: "HU"
    std::string comment;  ///< what the values are, a sentence
    std::span<const float> values;
};

/// Writes the values to an OpenEXR file as they are: float, one channel, with the facts as attributes.
Result<void> writeExr(ivec2 size, const ValueChannel& channel, const std::vector<Fact>& facts,
                      const std::filesystem::path& path);

}  // namespace pdr
