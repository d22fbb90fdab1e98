#pragma once
/// Makes the FlatGrid of an array of voxels, for the renderer and for all who read the values that it meets.

#include <cstdint>

#include "render/kernel/flat_scene.h"

namespace pdr {

/// Returns the grid of `voxels`, x fastest, then y, then z. It points to them and must not outlive them. Each component
/// of `size` is at least 1.
inline FlatGrid flatGrid(const std::int16_t* voxels, ivec3 size) {
    return {.voxels = voxels,
            .size = size,
            .lastIndex = vec3(size - 1),
            .lastCorner = glm::max(vec3(size - 2), vec3(0)),
            .stepX = size.x > 1 ? 1 : 0,
            .stepY = size.y > 1 ? size.x : 0,
            .stepZ = size.z > 1 ? std::int64_t(size.x) * size.y : 0};
}

/// Returns whether lanes can read the grid: they read voxels in pairs along x and count them in 32 bits.
inline bool lanesCanRead(const FlatGrid& grid) {
    const std::int64_t voxels = std::int64_t(grid.size.x) * grid.size.y * grid.size.z;
    return grid.size.x > 1 && voxels <= INT32_MAX;
}

}  // namespace pdr
