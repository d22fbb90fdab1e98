#pragma once
/// Portable float maps (PFM) of one channel, a format in which renderers exchange exact images.

#include <filesystem>
#include <vector>

#include "render/base/portable.h"
#include "render/base/result.h"

namespace pdr::bench {

/// Image of linear radiance, row by row from the top.
struct GreyImage {
    ivec2 size{0};
    std::vector<float> pixels;
};

/// Reads a little-endian file of one channel ("Pf", scale < 0). Errors: no such file, another format, too short.
Result<GreyImage> readPfm(const std::filesystem::path& path);
Result<void> writePfm(const GreyImage& image, const std::filesystem::path& path);

}  // namespace pdr::bench
