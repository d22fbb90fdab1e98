#include "render/segment/shells.h"

#include <new>

#include "render/base/errors.h"
#include "render/segment/body_mask.h"
#include "render/segment/bone_cells.h"
#include "render/segment/for_each_slice.h"
#include "render/segment/smooth_distance.h"
#include "render/segment/smoothed_hu.h"

namespace pdr::segment {
namespace {

constexpr std::string_view kStep = "separating the body parts";
constexpr double kSkinMm = 2, kRoomMm = 6;  ///< the second: distance known beyond, for smoothing
constexpr int kLeastHu = -20, kMostHu = 120;
constexpr int kAirHu = -300;  ///< below it, a voxel at the surface is air
constexpr std::uint8_t kSkin = 1, kMuscle = 2;

/// The body and its bones, and how deep a place lies below the skin.
struct Body {
    BodyMask mask;
    Cells bone;
    SmoothDistance depth;
};

/// Returns the part of a voxel that lies `depthMm` below the surface of the body; 0: none.
std::uint8_t partOf(const Body& body, const Volume& volume, ivec3 at, double depthMm) {
    const ivec3 cell = at / body.mask.grid.block;
    const std::size_t index = body.mask.grid.index(cell.x, cell.y, cell.z);
    const int hu = smoothedAt(volume, at);
    if (depthMm <= kSkinMm)
        return depthMm > 0 && hu > kAirHu ? kSkin : std::uint8_t(0);
    return body.mask.body[index] && !body.bone[index] && hu >= kLeastHu && hu <= kMostHu ? kMuscle : std::uint8_t(0);
}

LabelMap shellsOf(const Body& body, const Volume& volume, const LabelMap* taken, const Checkpoint& checkpoint) {
    const ivec3 size = volume.size();
    LabelMap map;
    map.geometry = volume.geometry();
    map.labels = HugePageVector<std::uint8_t>(volume.voxels().size());
    forEachSlice(size.z, checkpoint, [&](int z) {
        std::vector<double> depthMm(std::size_t(size.x));
        for (int y = 0; y < size.y; ++y) {
            body.depth.along({0, y, z}, 1, size.x, depthMm.data());
            const std::size_t row = (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x);
            for (int x = 0; x < size.x; ++x) {
                const std::size_t index = row + std::size_t(x);
                const bool isFree = !taken || taken->labels[index] == 0;
                map.labels[index] = isFree ? partOf(body, volume, {x, y, z}, depthMm[std::size_t(x)]) : std::uint8_t(0);
            }
        }
    });
    map.parts = {{"skin", {230, 190, 165}}, {"muscle", {165, 70, 60}}};
    map.source = phrase("a rule of this program");
    map.notes = {phrase("muscle is guessed by its density, which organs and marrow may have, too")};
    return map;
}

}  // namespace

Result<LabelMap> findShells(const Volume& volume, const LabelMap* taken, const Progress& progress) {
    Result<BodyMask> mask = bodyMask(volume, pdr::partOf(progress, 0, 0.5));
    if (!mask)
        return mask.error().kind == ErrorKind::refused
                   ? Error{phrase("skin and muscle cannot be found, because %1", mask.error().what), "", "",
                           ErrorKind::refused}
                   : mask.error();
    try {
        return orCancelled([&]() -> Result<LabelMap> {
            Cells bone = boneCells(volume, mask->grid, checkpointOf(progress, 0.5, kStep));
            SmoothDistance depth(mask->body, 0, mask->grid, kSkinMm + kRoomMm, checkpointOf(progress, 0.7, kStep));
            const Body body{*std::move(mask), std::move(bone), std::move(depth)};
            return shellsOf(body, volume, taken, checkpointOf(progress, 0.8, kStep));
        });
    } catch (const std::bad_alloc&) {
        return notEnoughMemoryForVoxels(volume.voxels().size(), "");
    }
}

}  // namespace pdr::segment
