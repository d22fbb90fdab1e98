#include "render/volume/coarser.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace pdr {
namespace {

/// Returns the geometry of the blocks of `block` voxels.
VolumeGeometry blocksOf(const VolumeGeometry& geometry, ivec3 block) {
    VolumeGeometry blocks;
    blocks.size = geometry.size / block;
    const dvec3 middle = dvec3(block - 1) * 0.5;  // middle of the first block, in voxels
    blocks.patientFromIndex[3] = geometry.patientFromIndex * dvec4(middle, 1);
    for (int axis = 0; axis < 3; ++axis)
        blocks.patientFromIndex[axis] = geometry.patientFromIndex[axis] * double(block[axis]);
    return blocks;
}

}  // namespace

Volume coarser(const Volume& volume, double edgeMm) {
    const VolumeGeometry& fine = volume.geometry();
    const ivec3 block = glm::clamp(ivec3(glm::round(dvec3(edgeMm) / fine.spacingMm())), ivec3(1), fine.size);
    const VolumeGeometry geometry = blocksOf(fine, block);
    const ivec3 size = geometry.size;
    Voxels voxels(geometry.voxelCount());
    tbb::parallel_for(0, size.z, [&](int k) {
        std::vector<std::int32_t> sums(static_cast<std::size_t>(size.x));
        std::int16_t* out = &voxels[std::size_t(k) * size.x * size.y];
        for (int j = 0; j < size.y; ++j, out += size.x) {
            std::ranges::fill(sums, 0);
            for (int z = k * block.z; z < (k + 1) * block.z; ++z)
                for (int y = j * block.y; y < (j + 1) * block.y; ++y) {
                    const std::int16_t* hu = &volume.voxels()[(std::size_t(z) * fine.size.y + y) * fine.size.x];
                    for (int i = 0; i < size.x; ++i)
                        for (int x = 0; x < block.x; ++x)
                            sums[std::size_t(i)] += *hu++;
                }
            for (int i = 0; i < size.x; ++i)
                out[i] = std::int16_t(sums[std::size_t(i)] / (block.x * block.y * block.z));
        }
    });
    return {geometry, std::move(voxels)};
}

LabelMap coarser(const LabelMap& map, const VolumeGeometry& blocks) {
    LabelMap coarse{blocks, {}, map.parts, map.source, {}};
    const ivec3 size = blocks.size, fine = map.geometry.size;
    const ivec3 block(glm::round(blocks.spacingMm() / map.geometry.spacingMm()));
    coarse.labels.resize(blocks.voxelCount());
    tbb::parallel_for(0, size.z, [&](int k) {
        std::uint8_t* out = &coarse.labels[std::size_t(k) * size.x * size.y];
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                const ivec3 middle = ivec3(i, j, k) * block + block / 2;
                *out++ = map.labels[(std::size_t(middle.z) * fine.y + middle.y) * fine.x + std::size_t(middle.x)];
            }
    });
    return coarse;
}

}  // namespace pdr
