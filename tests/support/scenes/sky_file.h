#pragma once
/// Environment maps on disk.

#include <filesystem>

#include "render/film/file/image_file.h"

namespace pdr::test {

/// Writes an OpenEXR file of `size` pixels with the radiance radianceAt(x, y).
template <class Radiance>
void writeSky(const std::filesystem::path& path, ivec2 size, Radiance&& radianceAt) {
    Film film(size, 0);
    const TileSums sums = film.sums(wholeImage(size));
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const dvec3 radiance(radianceAt(x, y));
            sums.pixels[y * size.x + x] = {
                .sum = 2.0 * radiance, .sumOfSquares = 2.0 * radiance * radiance, .count = 2};
        }
    film.commit({0, 2});
    if (!writeExr(film, {}, path))
        std::filesystem::remove(path);
}

}  // namespace pdr::test
