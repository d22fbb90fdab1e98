#pragma once
/// Encodes 8-bit sRGB images as PNG.

#include <cstdint>
#include <vector>

#include "render/base/portable.h"
#include "render/base/replacing_file.h"
#include "render/film/file/provenance.h"

namespace pdr {

/// Writes the image to `file`, with the facts as text chunks. `rgba`: 4 bytes a pixel, row by row from the top, the
/// last one of which is dropped. Returns false if libpng cannot encode it; failures of `file` are reported at its
/// commit().
bool encodePng(ivec2 size, std::vector<std::uint8_t>& rgba, std::vector<Fact> facts, ReplacingFile& file);

}  // namespace pdr
