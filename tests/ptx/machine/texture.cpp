#include "tests/ptx/machine/texture.h"

#include <algorithm>
#include <cmath>

namespace pdr::ptx {

namespace {

/// The two voxels that a coordinate lies between.
struct Axis {
    int low, high;
    int share;  ///< weight of the higher one, in 256ths

    Axis(f32 coordinate, int size) {
        // NaN gives some voxel; what lies far outside, the border.
        const f32 place = std::fmin(std::fmax(coordinate - 0.5f, -1.0f), f32(size));
        const f32 whole = std::floor(place);
        share = int(std::nearbyint((place - whole) * 256));
        low = std::clamp(int(whole), 0, size - 1);
        high = std::clamp(int(whole) + 1, 0, size - 1);
    }
};

}  // namespace

f32 Texture::linear(f32 x, f32 y, f32 z) const {
    const Axis axes[3] = {{x, size[0]}, {y, size[1]}, {z, size[2]}};
    s64 sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        s64 share = 1, at[3];
        for (int axis = 0; axis < 3; ++axis) {
            const bool high = (corner >> axis & 1) != 0;
            share *= high ? axes[axis].share : 256 - axes[axis].share;
            at[axis] = high ? axes[axis].high : axes[axis].low;
        }
        const s64 voxel = voxels[std::size_t((at[2] * size[1] + at[1]) * size[0] + at[0])];
        sum += share * std::max<s64>(voxel, -32767);
    }
    return f32(f64(sum) / (0x1p24 * 32767));
}

}  // namespace pdr::ptx
