#pragma once
/// The volume as a GPU's texture unit filters it: the weights of the eight voxels have 8 bits (CUDA C++ Programming
/// Guide, appendix "Texture Fetching", "Linear Filtering": 9-bit fixed point with 8 bits of fraction, so that 1 is
/// exact). The voxels are 16-bit numbers read as [-1, 1].
///   error    compared with interpolation in float, each of the three fractions is off by 1/512 at most, so that
///            |error| <= 3/512 of the range of the eight voxels + kTextureHuStep; see textureError()
///   bounds   the weights add up to 1 and are never negative, so that the result lies between the smallest and the
///            largest of the eight voxels, except for the rounding of two products in float, 2^-23 of the full scale.
///            Rounding to kTextureHuStep, of which every voxel's value is a multiple, removes that excess. Where all
///            eight voxels agree, the result is exactly their value, and kHuSlack (bounds/cell_bound.h) is never
///            needed.
///   assumed  the guide does not specify how a fraction is rounded (here: to the nearest 256th; truncation would double
///            the error), nor whether results between 16-bit numbers are rounded to 16 bits, as users of NVIDIA's GPUs
///            report (here: they are not; rounding would add an error of up to 0.5 HU). The bounds hold either way.

#include <cmath>
#include <cstdint>

#include "render/base/cells.h"
#include "render/kernel/flat_scene.h"

namespace pdr {

/// HU that a texture stores as 1. -1 stands for the lowest HU, so that INT16_MIN cannot be stored.
inline constexpr float kTextureFullHu = 32767;
inline constexpr float kTextureHuStep = 1.0f / 64;

/// Returns whether a texture can store all of `range`.
PDR_HD inline bool textureHolds(HuRange range) {
    return range.lowest >= -int(kTextureFullHu);
}

/// Returns the bound on the error of filtering [HU] between eight voxels whose values differ by `rangeHu`. The error
/// comes close to the bound at a corner of a cube in which one voxel differs from the other seven.
PDR_HD inline float textureError(float rangeHu) {
    return 3.0f / 512 * rangeHu + kTextureHuStep;
}

/// Returns the HU of a value that a texture returned.
PDR_HD inline float hounsfieldOfTexture(float value) {
    return std::rint(value * (kTextureFullHu / kTextureHuStep)) * kTextureHuStep;
}

#if defined(__CUDA_ARCH__)

/// Returns the filtered value at `position` (index space), in [-1, 1].
__device__ inline float textureValue(const FlatVolume& volume, vec3 position) {
    return tex3D<float>(volume.texture, position.x + 0.5f, position.y + 0.5f, position.z + 0.5f);
}

#else

/// Filtering along one axis: two voxels, and the fraction of the higher one in 256ths.
struct TextureAxis {
    int low, high, fraction;

    /// Accepts any `position` (index space).
    TextureAxis(float position, int size) {
        // Rounded as in textureValue() on a GPU.
        const float place = glm::clamp((position + 0.5f) - 0.5f, -1.0f, float(size));
        const float whole = std::floor(place);
        fraction = int(std::rint((place - whole) * 256));
        low = glm::clamp(int(whole), 0, size - 1);
        high = glm::clamp(int(whole) + 1, 0, size - 1);
    }
};

/// Returns the value at `position` (index space) in [-1, 1], computed as a texture unit does. It is slow and kept out
/// of line: on the CPU only an emulated GPU (device/emulated/host_gpu.h) calls it.
[[gnu::noinline, gnu::cold]] inline float textureValue(const FlatVolume& volume, vec3 position) {
    const TextureAxis x(position.x, volume.size.x), y(position.y, volume.size.y), z(position.z, volume.size.z);
    std::int64_t sum = 0;  // exact
    for (int n = 0; n < 8; ++n) {
        const std::int64_t i = n & 1 ? x.high : x.low, j = n & 2 ? y.high : y.low, k = n & 4 ? z.high : z.low;
        const std::int64_t fraction = std::int64_t(n & 1 ? x.fraction : 256 - x.fraction) *
                                      (n & 2 ? y.fraction : 256 - y.fraction) * (n & 4 ? z.fraction : 256 - z.fraction);
        sum += fraction * volume.voxels[(k * volume.size.y + j) * volume.size.x + i];
    }
    return float(double(sum) / (0x1p24 * double(kTextureFullHu)));
}

#endif

/// Returns the HU at `position` (index space) of a volume that has a texture.
PDR_HD inline float textureHounsfield(const FlatVolume& volume, vec3 position) {
    return hounsfieldOfTexture(textureValue(volume, position));
}

}  // namespace pdr
