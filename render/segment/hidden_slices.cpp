#include "render/segment/hidden_slices.h"

#include <algorithm>
#include <vector>

#include "render/segment/for_each_slice.h"
#include "render/segment/rule.h"

namespace pdr::segment {
namespace {

/// Returns the number of voxels in a slice.
std::size_t sliceVoxels(ivec3 size) {
    return std::size_t(size.x) * std::size_t(size.y);
}

/// Calls visit(y, hidden) for each row of slice `z`: a voxel whose number in `hidden` is -1 is not shown; 0: it is.
/// Numbers of the voxels' own width let the visits become vector instructions.
template <class Visit>
void forEachRow(const BodyMask& mask, int z, Visit visit) {
    const CellGrid& grid = mask.grid;
    std::vector<std::int16_t> hidden(std::size_t(grid.voxels.x));
    for (int y = 0; y < grid.voxels.y; ++y) {
        if (y % grid.block.y == 0) {
            const std::uint8_t* shown = &mask.shown[grid.index(0, y / grid.block.y, z / grid.block.z)];
            for (int x = 0; x < grid.voxels.x; x += grid.block.x, ++shown)
                std::fill_n(hidden.begin() + x, std::min(grid.block.x, grid.voxels.x - x),
                            std::int16_t(*shown ? 0 : -1));
        }
        visit(y, hidden.data());
    }
}

Outside outsideIn(const BodyMask& mask, int z, const std::int16_t* slice) {
    Outside all;
    const int length = mask.grid.voxels.x;
    forEachRow(mask, z, [&](int y, const std::int16_t* hidden) {
        const std::int16_t* row = slice + std::size_t(y) * std::size_t(length);
        int seen = 0;
        std::int16_t highest = INT16_MIN;
        for (int x = 0; x < length; ++x) {
            seen += hidden[x] & int(row[x] > kSeenHu);
            highest = std::max(highest, std::int16_t((row[x] & hidden[x]) | (INT16_MIN & ~hidden[x])));
        }
        all = {all.seen + seen, std::max(all.highest, highest)};
    });
    return all;
}

/// Replaces the voxels of slice `z` that are not shown with air.
void hideSlice(const BodyMask& mask, int z, std::int16_t* slice) {
    const int length = mask.grid.voxels.x;
    forEachRow(mask, z, [&](int y, const std::int16_t* hidden) {
        std::int16_t* row = slice + std::size_t(y) * std::size_t(length);
        for (int x = 0; x < length; ++x)
            row[x] = std::int16_t((row[x] & ~hidden[x]) | (Volume::kAirHu & hidden[x]));
    });
}

}  // namespace

Outside outsideOf(const BodyMask& mask, const Volume& volume, const Checkpoint& checkpoint) {
    const ivec3 size = volume.size();
    std::vector<Outside> slices(std::size_t(size.z));
    forEachSlice(size.z, checkpoint, [&](int z) {
        slices[std::size_t(z)] = outsideIn(mask, z, &volume.voxels()[sliceVoxels(size) * std::size_t(z)]);
    });
    Outside all;
    for (const Outside& slice : slices)
        all = {all.seen + slice.seen, std::max(all.highest, slice.highest)};
    return all;
}

Voxels hiddenCopy(const BodyMask& mask, const Volume& volume, const Checkpoint& checkpoint) {
    const std::size_t count = sliceVoxels(volume.size());
    Voxels voxels(volume.voxels().size());
    forEachSlice(volume.size().z, checkpoint, [&](int z) {
        const std::size_t first = count * std::size_t(z);
        std::copy_n(&volume.voxels()[first], count, &voxels[first]);
        hideSlice(mask, z, &voxels[first]);
    });
    return voxels;
}

void hideIn(std::span<std::int16_t> voxels, const BodyMask& mask, const SliceLoss& lost, const Checkpoint& checkpoint) {
    const std::size_t count = sliceVoxels(mask.grid.voxels);
    forEachSlice(mask.grid.voxels.z, checkpoint, [&](int z) {
        const std::span<std::int16_t> slice = voxels.subspan(count * std::size_t(z), count);
        const std::vector<std::int16_t> before(slice.begin(), slice.end());
        hideSlice(mask, z, slice.data());
        if (!std::ranges::equal(before, slice))
            lost(z, before, slice);
    });
}

}  // namespace pdr::segment
