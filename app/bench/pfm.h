#pragma once
/// Portable float maps of one channel: what renderers exchange when a picture must stay exact.

#include <filesystem>
#include <vector>

#include "render/base/portable.h"
#include "render/base/result.h"

namespace pdr::bench {

/// Linear radiance, row by row from the top.
struct GreyImage {
    ivec2 size{0};
    std::vector<float> pixels;
};

/// Little-endian, one channel ("Pf", scale < 0). Errors: no such file, another format, too short.
Result<GreyImage> readPfm(const std::filesystem::path& path);
Result<void> writePfm(const GreyImage& image, const std::filesystem::path& path);

}  // namespace pdr::bench
