#pragma once
/// HU without most of their noise: means over 3 x 3 voxels of the slice, weighted 1 2 1.

#include <algorithm>

#include "render/volume/volume.h"

namespace pdr::segment {

/// Returns the smoothed value at a voxel [HU]; beyond the border of the slice, its outermost voxels go on.
inline int smoothedAt(const Volume& volume, ivec3 at) {
    const ivec3 size = volume.size();
    const std::int16_t* slice = volume.voxels().data() + std::size_t(at.z) * std::size_t(size.y) * std::size_t(size.x);
    int sum = 0;
    for (int y = -1; y <= 1; ++y) {
        const std::int16_t* row = slice + std::size_t(std::clamp(at.y + y, 0, size.y - 1)) * std::size_t(size.x);
        const int left = row[std::max(at.x - 1, 0)], right = row[std::min(at.x + 1, size.x - 1)];
        sum += (y == 0 ? 2 : 1) * (left + 2 * row[at.x] + right);
    }
    return sum / 16;
}

}  // namespace pdr::segment
