#pragma once
/// The volume as a GPU's texture unit filters it: the shares of the eight voxels have 8 bits (CUDA C++ Programming
/// Guide, appendix "Texture Fetching", "Linear Filtering": 9-bit fixed point with 8 bits of fraction, so that 1 is
/// exact). The voxels are 16-bit numbers read as [-1, 1].
///   error   against interpolation in float: each of the three shares is off by 1/512 at most, so that
///           |error| <= 3/512 of the range of the eight voxels + kTextureHuStep; see textureError()
///   bounds  the shares add up to 1 and are never negative: what is found lies between the smallest and the largest of
///           the eight voxels, but for the rounding of two products in float, 2^-23 of the full scale. Rounding to
///           kTextureHuStep, of which every voxel's value is a multiple, takes that away: where all eight agree the
///           result is exactly theirs, and kHuSlack (cell_bound.h) is never needed.
///   unsaid  by the guide: how a fraction is rounded (here: to the nearest 256th; cut off, it would be wrong by twice
///   as
///           much), and whether what is found between 16-bit numbers is rounded to 16 bits, as users of NVIDIA's GPUs
///           report (here: it is not; it would be wrong by up to 0.5 HU more). Bounds hold either way.

#include <cmath>
#include <cstdint>

#include "render/base/cells.h"
#include "render/kernel/flat_scene.h"

namespace pdr {

/// HU that a texture holds as 1; -1 is the lowest, so that INT16_MIN has no place in it.
inline constexpr float kTextureFullHu = 32767;
inline constexpr float kTextureHuStep = 1.0f / 64;

/// Whether a texture can hold all of `range`.
PDR_HD inline bool textureHolds(HuRange range) {
    return range.lowest >= -int(kTextureFullHu);
}

/// How far filtering may be off [HU] between eight voxels whose values differ by `rangeHu`: at a corner of a cube where
/// one voxel stands against seven it comes near to that.
PDR_HD inline float textureError(float rangeHu) {
    return 3.0f / 512 * rangeHu + kTextureHuStep;
}

/// HU of what a texture returns.
PDR_HD inline float hounsfieldOfTexture(float value) {
    return std::rint(value * (kTextureFullHu / kTextureHuStep)) * kTextureHuStep;
}

#if defined(__CUDA_ARCH__)

/// At `position` (index space); [-1, 1].
__device__ inline float textureValue(const FlatVolume& volume, vec3 position) {
    return tex3D<float>(volume.texture, position.x + 0.5f, position.y + 0.5f, position.z + 0.5f);
}

#else

/// Along one axis: two voxels, and the fraction of the higher one in 256ths.
struct TextureAxis {
    int low, high, fraction;

    /// `position`: index space; any.
    TextureAxis(float position, int size) {
        const float place = glm::clamp((position + 0.5f) - 0.5f, -1.0f, float(size));  // rounded as on its way there
        const float whole = std::floor(place);
        fraction = int(std::rint((place - whole) * 256));
        low = glm::clamp(int(whole), 0, size - 1);
        high = glm::clamp(int(whole) + 1, 0, size - 1);
    }
};

/// At `position` (index space), computed as a texture unit does; [-1, 1]. Slow, and kept out of line: on the CPU only a
/// emulated GPU (device/cpu/host_gpu.h) comes here.
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

/// HU at `position` (index space) of a volume that has a texture.
PDR_HD inline float textureHounsfield(const FlatVolume& volume, vec3 position) {
    return hounsfieldOfTexture(textureValue(volume, position));
}

}  // namespace pdr
