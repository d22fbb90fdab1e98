#pragma once
/// Loads volumes from headerless files: voxels x fastest, then y, then z; little endian; the values are Hounsfield
/// units.

#include <filesystem>
#include <optional>

#include "render/base/result.h"
#include "render/volume/volume.h"

namespace pdr {

struct RawFile {
    enum class Type { int16, uint16, uint8, float32 };

    std::filesystem::path path;
    Type type = Type::int16;
    ivec3 size{0};                  ///< voxels; each in [1, 65536]
    dvec3 spacingMm{1};             ///< each in (0, 1e6]
    std::optional<dvec3> originMm;  ///< centre of voxel (0,0,0); default half a spacing, so that the box starts at 0
    bool operator==(const RawFile&) const = default;
};

/// Returns the file's voxels as int16 HU, floats rounded. Errors: no such file, a size in bytes that does not match the
/// dimensions, a value outside int16, not enough memory.
Result<Volume> loadRaw(const RawFile& file);

}  // namespace pdr
