#include "app/bench/pfm.h"
#include "render/base/image_size.h"

#include <fstream>

namespace pdr::bench {

Result<GreyImage> readPfm(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return Error{"the image cannot be opened", path.string(), ""};
    std::string kind;
    ivec2 size(0);
    float scale = 0;
    file >> kind >> size.x >> size.y >> scale;
    file.get();  // the one white space before the data
    if (!file || kind != "Pf" || scale >= 0 || size.x < 1 || size.y < 1 || size.x > kLongestSide ||
        size.y > kLongestSide)
        return Error{"this is no little-endian one-channel PFM", path.string(), ""};
    GreyImage image{size, std::vector<float>(std::size_t(size.x) * size.y)};
    for (int y = size.y - 1; y >= 0; --y)  // bottom row first
        file.read(reinterpret_cast<char*>(image.pixels.data() + std::size_t(y) * size.x),
                  std::streamsize(size.x * sizeof(float)));
    if (!file)
        return Error{"the file ends before its last pixel", path.string(), ""};
    return image;
}

Result<void> writePfm(const GreyImage& image, const std::filesystem::path& path) {
    std::ofstream file(path, std::ios::binary);
    file << "Pf\n" << image.size.x << ' ' << image.size.y << "\n-1\n";
    for (int y = image.size.y - 1; y >= 0; --y)
        file.write(reinterpret_cast<const char*>(image.pixels.data() + std::size_t(y) * image.size.x),
                   std::streamsize(image.size.x * sizeof(float)));
    file.flush();
    if (!file)
        return Error{"the image cannot be written", path.string(), "Is the folder there, and is there room?"};
    return {};
}

}  // namespace pdr::bench
