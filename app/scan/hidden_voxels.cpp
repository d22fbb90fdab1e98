#include "app/scan/hidden_voxels.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <utility>

#include "app/wire/one_frame.h"
#include "render/segment/for_each_slice.h"

namespace pdr::app {
namespace {

constexpr int kLevel = 1;  ///< compression level of zstd

std::size_t voxelsOfSlice(const Volume& volume) {
    return std::size_t(volume.size().x) * std::size_t(volume.size().y);
}

std::span<const std::int16_t> sliceOf(const Volume& volume, int z) {
    return volume.voxels().subspan(std::size_t(z) * voxelsOfSlice(volume), voxelsOfSlice(volume));
}

/// Writes a xor b to `out`, which may be either of them.
void combine(std::span<const std::int16_t> a, std::span<const std::int16_t> b, std::span<std::int16_t> out) {
    std::ranges::transform(a, b, out.begin(), [](int one, int other) { return std::int16_t(one ^ other); });
}

std::vector<std::byte> packed(std::span<const std::int16_t> scan, std::span<const std::int16_t> seen) {
    if (std::ranges::equal(scan, seen))
        return {};
    std::vector<std::int16_t> both(scan.size());
    combine(scan, seen, both);
    std::vector<std::byte> halves(both.size() * sizeof(std::int16_t));
    wire::splitBytes(std::as_bytes(std::span(both)), halves);
    return wire::packedFrame({}, halves, kLevel);
}

/// Turns the slice without the table into that of the scan, in place.
void unpack(const std::vector<std::byte>& frame, std::span<std::int16_t> voxels) {
    std::vector<std::byte> halves(voxels.size_bytes());
    [[maybe_unused]] const bool whole = wire::FrameUnpacker().unpack(frame, halves);
    assert(whole);
    std::vector<std::int16_t> both(voxels.size());
    wire::joinBytes(halves, std::as_writable_bytes(std::span(both)));
    combine(voxels, both, voxels);
}

}  // namespace

Result<HiddenVoxels> HiddenVoxels::of(const Volume& scan, const Volume& seen, const Progress& progress) {
    assert(scan.size() == seen.size());
    return segment::orCancelled([&]() -> Result<HiddenVoxels> {
        HiddenVoxels hidden(scan.size().z);
        segment::forEachSlice(scan.size().z, segment::checkpointOf(progress, 1, "hiding the table"),
                              [&](int z) { hidden.keep(z, sliceOf(scan, z), sliceOf(seen, z)); });
        return hidden;
    });
}

void HiddenVoxels::keep(int slice, std::span<const std::int16_t> scan, std::span<const std::int16_t> seen) {
    slices_[std::size_t(slice)] = packed(scan, seen);
}

Volume HiddenVoxels::scanOf(const Volume& seen) const {
    Voxels voxels(seen.voxels().begin(), seen.voxels().end());
    segment::forEachSlice(seen.size().z, segment::goOn, [&](int z) {
        if (const std::vector<std::byte>& frame = slices_[std::size_t(z)]; !frame.empty())
            unpack(frame, std::span(voxels).subspan(std::size_t(z) * voxelsOfSlice(seen), voxelsOfSlice(seen)));
    });
    return seen.withVoxels(std::move(voxels), {});
}

std::size_t HiddenVoxels::bytes() const {
    std::size_t sum = 0;
    for (const std::vector<std::byte>& frame : slices_)
        sum += frame.size();
    return sum;
}

}  // namespace pdr::app
