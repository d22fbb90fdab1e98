#include "app/cli/scan/cranium.h"

#include <bit>
#include <fstream>
#include <vector>

namespace pdr::app {

namespace {

constexpr ivec3 kSize{256, 256, 108};
constexpr dvec3 kSpacingMm{0.9570312, 0.9570312, 1.5};
static_assert(std::endian::native == std::endian::little, "the matrix is read as it lies");

}  // namespace

Result<Volume> readCranium(const std::filesystem::path& matrixFile) {
    const VolumeGeometry geometry =
        VolumeGeometry::aligned(kSize, kSpacingMm, -0.5 * (dvec3(kSize) - 1.0) * kSpacingMm);
    Voxels voxels(geometry.voxelCount());
    std::error_code failure;
    const std::uintmax_t bytes = std::filesystem::file_size(matrixFile, failure);
    std::ifstream file(matrixFile, std::ios::binary);
    if (failure || !file)
        return Error{"the file cannot be opened", matrixFile.string(),
                     "It is matrix.dat inside Cranium.inv3, a tar.gz."};
    if (bytes != voxels.size() * sizeof voxels[0])
        return Error{"the file holds " + std::to_string(bytes) + " bytes, not 256 x 256 x 108 voxels of two bytes",
                     matrixFile.string(), "It is matrix.dat inside Cranium.inv3, a tar.gz."};
    for (int z = 0; z < kSize.z; ++z) {
        for (int y = kSize.y - 1; y >= 0; --y) {
            const std::size_t row = (std::size_t(z) * std::size_t(kSize.y) + std::size_t(y)) * std::size_t(kSize.x);
            file.read(reinterpret_cast<char*>(&voxels[row]), std::streamsize(kSize.x * sizeof voxels[0]));
        }
    }
    if (!file)
        return Error{"the file cannot be read to its end", matrixFile.string(), ""};
    return Volume(geometry, std::move(voxels));
}

}  // namespace pdr::app
