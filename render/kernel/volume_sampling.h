#pragma once
/// The volume between its voxels: trilinear interpolation, borders clamped, and its gradient. In float, but for the
/// function of single places where the volume has a texture: that one is filtered as texture units do.

#include "render/base/lanes.h"
#include "render/kernel/texture.h"

namespace pdr {

/// HU at `position` (index space), exactly. Where all eight voxels agree the result is theirs.
PDR_HD inline float interpolatedHounsfield(const FlatVolume& volume, vec3 position) {
    const float x = glm::clamp(position.x, 0.0f, volume.lastIndex.x);
    const float y = glm::clamp(position.y, 0.0f, volume.lastIndex.y);
    const float z = glm::clamp(position.z, 0.0f, volume.lastIndex.z);
    // At the last voxel the interpolation cell before it is used, with fraction 1.
    const int i = int(glm::min(x, volume.lastCorner.x));
    const int j = int(glm::min(y, volume.lastCorner.y));
    const int k = int(glm::min(z, volume.lastCorner.z));
    const float a = x - float(i), b = y - float(j), c = z - float(k);
    const int dx = volume.stepX;
    const std::int16_t* v = volume.voxels + k * volume.stepZ + j * volume.stepY + i;
    const auto along = [a, dx](const std::int16_t* row) {
        const float first = row[0];
        return first + (float(row[dx]) - first) * a;
    };
    const float v00 = along(v), v10 = along(v + volume.stepY);
    const float v01 = along(v + volume.stepZ), v11 = along(v + volume.stepZ + volume.stepY);
    const float low = v00 + (v10 - v00) * b;
    const float high = v01 + (v11 - v01) * b;
    return low + (high - low) * c;
}

/// The same, or as texture units filter it where the volume has a texture.
PDR_HD inline float hounsfield(const FlatVolume& volume, vec3 position) {
    if (volume.texture != 0) [[unlikely]]  // on the CPU
        return textureHounsfield(volume, position);
    return interpolatedHounsfield(volume, position);
}

PDR_HD inline float hounsfield(const FlatVolume& volume, const Vec3<float>& position) {
    return hounsfield(volume, vec3(position.x, position.y, position.z));
}

#if !defined(__CUDACC__)

/// The same in step, bit by bit. For volumes of at least two voxels along x and fewer than 2^31 in all.
PDR_HD_INLINE FloatLanes hounsfield(const FlatVolume& volume, const Vec3<FloatLanes>& position) {
    const auto clamped = [](FloatLanes value, float high) {
        return min(max(value, FloatLanes{}), FloatLanes{} + high);
    };
    const FloatLanes x = clamped(position.x, volume.lastIndex.x);
    const FloatLanes y = clamped(position.y, volume.lastIndex.y);
    const FloatLanes z = clamped(position.z, volume.lastIndex.z);
    const IntLanes i = toInt(min(x, FloatLanes{} + volume.lastCorner.x));
    const IntLanes j = toInt(min(y, FloatLanes{} + volume.lastCorner.y));
    const IntLanes k = toInt(min(z, FloatLanes{} + volume.lastCorner.z));
    const FloatLanes a = x - toFloat(i), b = y - toFloat(j), c = z - toFloat(k);
    const IntLanes index = (k * volume.size.y + j) * volume.size.x + i;
    const auto along = [a, index](const std::int16_t* row) {
        FloatLanes first, second;
        gatherPair(row, index, first, second);
        return first + (second - first) * a;
    };
    const std::int16_t* v = volume.voxels;
    const FloatLanes v00 = along(v), v10 = along(v + volume.stepY);
    const FloatLanes v01 = along(v + volume.stepZ), v11 = along(v + volume.stepZ + volume.stepY);
    const FloatLanes low = v00 + (v10 - v00) * b;
    const FloatLanes high = v01 + (v11 - v01) * b;
    return low + (high - low) * c;
}

#endif

/// The eight voxels between which trilinear interpolation is one formula: [x + 2 y + 4 z] from the lowest corner.
template <class Real>
struct Cube {
    Vec3<Real> lowest;  ///< index space
    Real hu[8];
};

/// The cube that holds the points whose index coordinates have the whole parts `i`, `j`, `k`; at the volume's borders
/// the outermost one.
PDR_HD_INLINE Cube<float> cubeAt(const FlatVolume& volume, int i, int j, int k) {
    i = glm::clamp(i, 0, int(volume.lastCorner.x));
    j = glm::clamp(j, 0, int(volume.lastCorner.y));
    k = glm::clamp(k, 0, int(volume.lastCorner.z));
    Cube<float> cube;
    cube.lowest = {float(i), float(j), float(k)};
    const std::int16_t* v = volume.voxels + k * volume.stepZ + j * volume.stepY + i;
    for (int n = 0; n < 8; ++n)
        cube.hu[n] = v[(n & 1) * volume.stepX + ((n >> 1) & 1) * volume.stepY + (n >> 2) * volume.stepZ];
    return cube;
}

#if !defined(__CUDACC__)

PDR_HD_INLINE Cube<FloatLanes> cubeAt(const FlatVolume& volume, IntLanes i, IntLanes j, IntLanes k) {
    const auto inside = [](IntLanes value, float last) {
        const IntLanes high = IntLanes{} + int(last);
        value = value < 0 ? IntLanes{} : value;
        return value > high ? high : value;
    };
    i = inside(i, volume.lastCorner.x);
    j = inside(j, volume.lastCorner.y);
    k = inside(k, volume.lastCorner.z);
    Cube<FloatLanes> cube;
    cube.lowest = {toFloat(i), toFloat(j), toFloat(k)};
    const IntLanes index = (k * volume.size.y + j) * volume.size.x + i;
    for (int n = 0; n < 8; n += 2) {
        const std::int16_t* row = volume.voxels + ((n >> 1) & 1) * volume.stepY + (n >> 2) * volume.stepZ;
        gatherPair(row, index, cube.hu[n], cube.hu[n + 1]);
    }
    return cube;
}

#endif

/// HU at `position`, which lies in the cube or, by rounding, just beside it.
template <class Real>
PDR_HD_INLINE Real hounsfield(const Cube<Real>& cube, const Vec3<Real>& position) {
    const auto fraction = [](Real place, Real lowest) { return min(max(place - lowest, Real{}), Real{} + 1.0f); };
    const Real a = fraction(position.x, cube.lowest.x), b = fraction(position.y, cube.lowest.y);
    const Real c = fraction(position.z, cube.lowest.z);
    const auto along = [&](int n) { return cube.hu[n] + (cube.hu[n + 1] - cube.hu[n]) * a; };
    const Real v00 = along(0), v10 = along(2), v01 = along(4), v11 = along(6);
    const Real low = v00 + (v10 - v00) * b;
    const Real high = v01 + (v11 - v01) * b;
    return low + (high - low) * c;
}

/// Local position [mm] of an index-space position.
PDR_HD inline vec3 localPosition(const FlatVolume& volume, vec3 position) {
    return volume.localFromIndex * (position - 0.5f * volume.lastIndex);
}

/// The gradient of what read(position) returns [HU].
template <class Read>
PDR_HD inline vec3 gradientOf(const FlatVolume& volume, vec3 position, Read&& read) {
    const auto difference = [&](vec3 offset) { return 0.5f * (read(position + offset) - read(position - offset)); };
    const vec3 perIndex(difference({1, 0, 0}), difference({0, 1, 0}), difference({0, 0, 1}));
    return glm::transpose(volume.indexFromLocal) * perIndex;
}

/// Gradient of the HU in local space [HU/mm], by central differences over one voxel to each side.
PDR_HD inline vec3 hounsfieldGradient(const FlatVolume& volume, vec3 position) {
    if (volume.texture != 0) [[unlikely]]  // asked once: on the CPU, six times would be felt
        return gradientOf(volume, position, [&](vec3 place) { return textureHounsfield(volume, place); });
    return gradientOf(volume, position, [&](vec3 place) { return interpolatedHounsfield(volume, place); });
}

}  // namespace pdr
