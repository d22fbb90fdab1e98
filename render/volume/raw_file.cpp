#include "render/volume/raw_file.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <new>
#include <string>
#include <vector>

#include "render/base/errors.h"

namespace pdr {
namespace {

static_assert(std::endian::native == std::endian::little, "raw files are read as they lie in memory");

std::size_t bytesPerVoxel(RawFile::Type type) {
    switch (type) {
        case RawFile::Type::uint8:
            return 1;
        case RawFile::Type::float32:
            return 4;
        case RawFile::Type::int16:
        case RawFile::Type::uint16:
            break;
    }
    return 2;
}

Text count(ivec3 size) {
    return phrase("%1 x %2 x %3", size.x, size.y, size.z);
}

Result<void> checkBytes(const RawFile& file) {
    std::error_code failure;
    const std::uintmax_t found = std::filesystem::file_size(file.path, failure);
    if (failure)
        return Error{phrase("the file cannot be read (%1)", failure.message()), file.path.string(),
                     phrase("Check the path.")};
    const std::uintmax_t needed = std::uintmax_t(file.size.x) * std::uintmax_t(file.size.y) *
                                  std::uintmax_t(file.size.z) * bytesPerVoxel(file.type);
    if (found == needed)
        return {};
    return Error{phrase("the file holds %1 bytes, %2 voxels of this type are %3", found, count(file.size), needed),
                 file.path.string(), phrase("Check size and type.")};
}

Error readError(const RawFile& file) {
    return {phrase("the file could not be read to its end"), file.path.string(),
            phrase("Check the disk that it lies on.")};
}

template <class T>
Result<HugePageVector<T>> readAll(const RawFile& file, std::size_t voxels) {
    HugePageVector<T> values(voxels);
    std::ifstream stream(file.path, std::ios::binary);
    if (!stream)
        return Error{phrase("the file cannot be opened"), file.path.string(), phrase("Check that you may read it.")};
    stream.read(reinterpret_cast<char*>(values.data()), std::streamsize(voxels * sizeof(T)));
    if (!stream)
        return readError(file);
    return values;
}

/// Reads values of type T and rounds them to int16.
template <class T>
Result<Voxels> readAs(const RawFile& file, std::size_t voxels) {
    Result<HugePageVector<T>> values = readAll<T>(file, voxels);
    if (!values)
        return values.error();
    Voxels hu(voxels);
    for (std::size_t i = 0; i < voxels; ++i) {
        const double rounded = std::nearbyint(double((*values)[i]));
        if (!(rounded >= INT16_MIN && rounded <= INT16_MAX))
            return Error{phrase("voxel %1 holds %2, Hounsfield units end at 32767 and begin at -32768", i,
                                numberOf(double((*values)[i]))),
                         file.path.string(), phrase("Check the type, and that the file is little endian.")};
        hu[i] = std::int16_t(rounded);
    }
    return hu;
}

Result<Voxels> readVoxels(const RawFile& file, std::size_t voxels) {
    switch (file.type) {
        case RawFile::Type::uint8:
            return readAs<std::uint8_t>(file, voxels);
        case RawFile::Type::uint16:
            return readAs<std::uint16_t>(file, voxels);
        case RawFile::Type::float32:
            return readAs<float>(file, voxels);
        case RawFile::Type::int16:
            break;
    }
    return readAll<std::int16_t>(file, voxels);
}

}  // namespace

Result<Volume> loadRaw(const RawFile& file) {
    if (auto ok = checkSpacing(file.spacingMm); !ok)
        return Error{ok.error().what, file.path.string(), ok.error().hint};
    if (auto ok = checkBytes(file); !ok)
        return ok.error();
    const VolumeGeometry geometry =
        VolumeGeometry::aligned(file.size, file.spacingMm, file.originMm.value_or(0.5 * file.spacingMm));
    try {
        Result<Voxels> voxels = readVoxels(file, geometry.voxelCount());
        if (!voxels)
            return voxels.error();
        return Volume(geometry, *std::move(voxels));
    } catch (const std::bad_alloc&) {
        return notEnoughMemory(phrase("for %1 voxels (%2)", count(file.size), bytesText(geometry.voxelCount() * 2)),
                               file.path.string(), phrase("Close other programs, or take a smaller volume."));
    }
}

}  // namespace pdr
