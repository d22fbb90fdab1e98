#include "render/smooth/noise_level.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pdr {
namespace {

constexpr int kBlock = 8;          ///< voxels along the edge of a block
constexpr int kMostSlices = 64;    ///< slices that are looked at
constexpr double kQuantile = 0.1;  ///< part of the blocks that deviate less than the noise

struct Block {
    double mean, deviation;
};

/// Returns the block whose first voxel is `first`; its deviation is 0 if it is not to be used.
Block blockAt(const Volume& volume, std::size_t first) {
    std::int64_t sum = 0, squares = 0;
    for (int j = 0; j < kBlock; ++j)
        for (int i = 0; i < kBlock; ++i) {
            const std::size_t index = first + std::size_t(j) * std::size_t(volume.size().x) + std::size_t(i);
            if (volume.isPadding(index))
                return {0, 0};
            const std::int64_t value = volume.voxels()[index];
            sum += value;
            squares += value * value;
        }
    constexpr int kCount = kBlock * kBlock;
    const double mean = double(sum) / kCount;
    return {mean, std::sqrt(std::max(0.0, double(squares * kCount - sum * sum)) / (kCount * (kCount - 1.0)))};
}

std::vector<Block> blocksOf(const Volume& volume, int slice) {
    std::vector<Block> blocks;
    const ivec3 size = volume.size();
    for (int j = 0; j + kBlock <= size.y; j += kBlock)
        for (int i = 0; i + kBlock <= size.x; i += kBlock)
            if (const Block block = blockAt(volume, (std::size_t(slice) * size.y + j) * size.x + i);
                block.deviation > 0)
                blocks.push_back(block);
    return blocks;
}

/// Returns the blocks of slices that are spread evenly over the scan.
std::vector<Block> blocksOf(const Volume& volume) {
    const int slices = std::min(volume.size().z, kMostSlices);
    std::vector<std::vector<Block>> each{std::size_t(slices)};
    tbb::parallel_for(
        0, slices, [&](int k) { each[std::size_t(k)] = blocksOf(volume, int((k + 0.5) * volume.size().z / slices)); });
    std::vector<Block> blocks;
    for (const std::vector<Block>& some : each)
        blocks.insert(blocks.end(), some.begin(), some.end());
    return blocks;
}

}  // namespace

double noiseOf(const Volume& volume) {
    std::vector<Block> blocks = blocksOf(volume);
    double sum = 0;
    for (const Block& block : blocks)
        sum += block.mean;
    const double mean = sum / double(std::max<std::size_t>(1, blocks.size()));
    std::erase_if(blocks, [mean](const Block& block) { return block.mean < mean; });
    if (blocks.empty())
        return 0;
    const auto quantile = blocks.begin() + std::ptrdiff_t(kQuantile * double(blocks.size()));
    std::ranges::nth_element(blocks, quantile, {}, &Block::deviation);
    return quantile->deviation;
}

}  // namespace pdr
