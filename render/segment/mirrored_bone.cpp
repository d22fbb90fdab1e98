#include "render/segment/mirrored_bone.h"

#include <algorithm>
#include <new>

#include "render/base/errors.h"
#include "render/segment/body_mask.h"
#include "render/segment/bone_cells.h"
#include "render/segment/distance.h"
#include "render/segment/for_each_slice.h"
#include "render/segment/pieces.h"
#include "render/segment/symmetry.h"

namespace pdr::segment {
namespace {

constexpr std::string_view kStep = "mirroring the bones";
constexpr double kPoorMm = 3;
constexpr double kApartMm = 6, kEdgeMm = 8;  ///< the second: a little more than the first, in cells of 2 mm
constexpr double kLeastMl = 1;
constexpr int kBoneHu = 250;

Error refused(const Text& why) {
    return {phrase("mirrored bone cannot be found, because %1", why), "", "", ErrorKind::refused};
}

/// The scan at places between its voxels and beyond: trilinear, and air outside.
class Sampled {
  public:
    explicit Sampled(const Volume& volume) : volume_(volume) {}

    double hu(const dvec3& index) const {
        const ivec3 size = volume_.size(), low(glm::floor(index));
        if (glm::any(glm::lessThan(low, ivec3(0))) || glm::any(glm::greaterThanEqual(low + 1, size)))
            return Volume::kAirHu;
        const dvec3 f = index - dvec3(low);
        const std::size_t row = std::size_t(size.x), slice = row * std::size_t(size.y);
        const std::int16_t* at =
            volume_.voxels().data() + std::size_t(low.z) * slice + std::size_t(low.y) * row + low.x;
        const auto along = [&](const std::int16_t* hu) { return glm::mix(double(hu[0]), double(hu[1]), f.x); };
        const auto plane = [&](const std::int16_t* hu) { return glm::mix(along(hu), along(hu + row), f.y); };
        return glm::mix(plane(at), plane(at + slice), f.z);
    }

  private:
    const Volume& volume_;
};

/// Places of a scan and their mirror images, both in index space.
struct Mirror {
    SymmetryPlane plane;
    dmat4 patientFromIndex, indexFromPatient;

    dvec3 operator()(const dvec3& index) const {
        return dvec3(indexFromPatient * dvec4(plane.mirrored(dvec3(patientFromIndex * dvec4(index, 1))), 1));
    }
};

/// Returns the cells around which the bones of one side are lacking on the other.
Cells lacking(const Cells& bones, const CellGrid& grid, const Mirror& mirror, const Checkpoint& checkpoint) {
    const std::vector<float> fromBones = squaredDistances(bones, 1, grid, kApartMm, checkpoint);
    Cells missing(bones.size()), core(bones.size());
    forEachSlice(grid.size.z, checkpoint, [&](int z) {
        for (int y = 0; y < grid.size.y; ++y)
            for (int x = 0; x < grid.size.x; ++x) {
                const dvec3 there = mirror((dvec3(x, y, z) + 0.5) * dvec3(grid.block) - 0.5);
                const ivec3 cell(glm::floor((there + 0.5) / dvec3(grid.block)));
                if (glm::any(glm::lessThan(cell, ivec3(0))) || glm::any(glm::greaterThanEqual(cell, grid.size)))
                    continue;
                const std::size_t at = grid.index(x, y, z);
                missing[at] = bones[grid.index(cell.x, cell.y, cell.z)] && !bones[at];
                core[at] = missing[at] && atLeast(fromBones[at], kApartMm);
            }
    });
    core = piecesWith(core, kLeastMl / grid.cellMl(), core, grid, checkpoint);
    return std::ranges::find(core, 1) == core.end() ? Cells() : widened(core, grid, kEdgeMm, checkpoint);
}

Result<LabelMap> mirroredBone(const Volume& volume, const BodyMask& body, const Progress& progress) {
    const CellGrid& grid = body.grid;
    Cells bones = boneCells(volume, grid, checkpointOf(progress, 0.4, kStep));
    for (std::size_t i = 0; i < bones.size(); ++i)
        bones[i] = bones[i] && body.body[i];
    if (std::ranges::find(bones, 1) == bones.end())
        return refused(phrase("no bones are in this scan"));
    const dmat4& axes = volume.geometry().patientFromIndex;
    const Mirror mirror{symmetryOf(bones, grid, volume.geometry(), checkpointOf(progress, 0.6, kStep)), axes,
                        glm::inverse(axes)};
    if (mirror.plane.medianMm > kPoorMm)
        return refused(
            phrase("half of the bones lie more than %1 mm from their mirror image: this body is not symmetric",
                   numberOf(mirror.plane.medianMm, 2)));
    const Cells around = lacking(bones, grid, mirror, checkpointOf(progress, 0.8, kStep));
    if (around.empty())
        return refused(phrase("no bone of 1 ml that one side has is lacking on the other"));
    LabelMap map;
    map.geometry = volume.geometry();
    map.labels = HugePageVector<std::uint8_t>(volume.voxels().size());
    const Sampled scan(volume);
    const ivec3 size = volume.size();
    forEachSlice(size.z, checkpointOf(progress, 0.9, kStep), [&](int z) {
        std::size_t index = std::size_t(z) * std::size_t(size.y) * std::size_t(size.x);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x, ++index)
                map.labels[index] = around[grid.index(x / grid.block.x, y / grid.block.y, z / grid.block.z)] &&
                                    volume.voxels()[index] < kBoneHu && scan.hu(mirror(dvec3(x, y, z))) >= kBoneHu;
    });
    map.parts = {{"mirrored bone", {120, 190, 235}}};
    map.source = phrase("a rule of this program");
    map.notes = {
        phrase("mirrored bone is the other side's: half of the bones lie within %1 mm of their mirror image, nine "
               "tenths within %2 mm",
               numberOf(mirror.plane.medianMm, 2), numberOf(mirror.plane.mostMm, 2))};
    return map;
}

}  // namespace

Result<LabelMap> findMirroredBone(const Volume& volume, const Progress& progress) {
    const Result<BodyMask> body = bodyMask(volume, pdr::partOf(progress, 0, 0.3));
    if (!body)
        return body.error().kind == ErrorKind::refused ? refused(body.error().what) : body.error();
    try {
        return orCancelled([&] { return mirroredBone(volume, *body, progress); });
    } catch (const std::bad_alloc&) {
        return notEnoughMemoryForVoxels(volume.voxels().size(), "");
    }
}

}  // namespace pdr::segment
