#include "render/segment/vessels.h"

#include <algorithm>
#include <new>

#include "render/base/errors.h"
#include "render/segment/blood_cells.h"
#include "render/segment/body_mask.h"
#include "render/segment/bone_cells.h"
#include "render/segment/cell_values.h"
#include "render/segment/distance.h"
#include "render/segment/findings.h"
#include "render/segment/for_each_slice.h"
#include "render/segment/lung_cells.h"
#include "render/segment/pieces.h"
#include "render/segment/smoothed_hu.h"
#include "render/segment/voxel_flood.h"
#include "render/volume/value_unit.h"

namespace pdr::segment {
namespace {

constexpr std::string_view kStep = "looking for vessels";
constexpr float kFaintestHu = 200;                  ///< blood below it cannot be told from marrow
constexpr double kCoreShare = 0.75;                 ///< least value of a pool, as a share of the blood's
constexpr double kVesselShare = 0.5;                ///< least value of a vessel, likewise ...
constexpr int kLeastHu = 150, kMostHu = 210;        ///< ... within these
constexpr double kBoneShare = 1.4;                  ///< least value of bone that is certain, likewise ...
constexpr int kBoneHu = 350;                        ///< ... but not less than this
constexpr double kBesideMm = 8;                     ///< so near to a pool, bone is not known to be bone
constexpr double kUndilutedShare = 2;               ///< least value of undiluted medium, likewise ...
constexpr int kUndilutedHu = 700, kMetalHu = 2500;  ///< ... within these
constexpr double kSolidMm = 3, kSolidMl = 0.5;      ///< balls of a vein full of it, and what their centres fill
constexpr double kRimMm = 3;                        ///< beside such a vein, its own rim is as dense as bone
constexpr double kBesideLungMm = 40;                ///< so near to a lung no bone is as solid
constexpr int kLungVesselHu = -250;
constexpr double kLungVesselMm = 8, kPleuraMm = 5;  ///< as for the lungs that are shown (body_parts.cpp)
constexpr std::uint8_t kBlood = 1, kBone = 2;

Error refused(const Text& why) {
    return {phrase("vessels cannot be found, because %1", why), "",
            phrase("Take a scan with contrast medium, or a label map of another program."), ErrorKind::refused};
}

/// The cells in which blood, bone and the inside of the lungs lie for certain.
struct Markers {
    CellGrid grid;
    Cells blood, bone, lung;
};

/// Returns the cells inside the lungs, vessels included, without the outermost layer; none without lungs or body.
Cells insideLungs(const Volume& volume, const CellGrid& grid, const Progress& progress, const Checkpoint& checkpoint) {
    const Result<BodyMask> body = bodyMask(volume, progress);
    if (!body && body.error().kind == ErrorKind::cancelled)
        throw Stopped{};
    Cells inside(grid.count());
    if (!body)
        return inside;
    const Cells wide = widened(lungCells(volume, *body, checkpoint), grid, kLungVesselMm, checkpoint);
    const std::vector<float> depths = squaredDistances(wide, 0, grid, kLungVesselMm + kPleuraMm, checkpoint);
    for (std::size_t i = 0; i < inside.size(); ++i)
        inside[i] = wide[i] && atLeast(depths[i], kLungVesselMm + kPleuraMm);
    return inside;
}

/// Returns the veins full of undiluted medium: what is denser than bone, solid, near a lung, and beside a pool of
/// blood.
Cells undilutedVeins(const CellValues& values, const Markers& markers, const std::vector<float>& fromBlood,
                     float bloodHu, const Checkpoint& checkpoint) {
    const CellGrid& grid = markers.grid;
    const int least = std::max(kUndilutedHu, int(kUndilutedShare * bloodHu));
    Cells dense(grid.count()), solid(grid.count()), beside(grid.count());
    for (std::size_t i = 0; i < dense.size(); ++i)
        dense[i] = values.mean[i] > least && values.mean[i] < kMetalHu;
    const std::vector<float> depths = squaredDistances(dense, 0, grid, kSolidMm, checkpoint);
    const Cells nearLung = widened(markers.lung, grid, kBesideLungMm, checkpoint);
    for (std::size_t i = 0; i < dense.size(); ++i) {
        solid[i] = dense[i] && nearLung[i] && atLeast(depths[i], kSolidMm);
        beside[i] = dense[i] && atMost(fromBlood[i], kBesideMm);
    }
    const Cells veins = piecesWith(solid, kSolidMl / grid.cellMl(), dense, grid, checkpoint);
    return piecesWith(beside, 1, veins, grid, checkpoint);
}

Markers markersOf(const Volume& volume, float bloodHu, const Progress& progress) {
    Markers markers;
    const CellGrid& grid = markers.grid = CellGrid::over(volume.geometry());
    const Checkpoint checkpoint = checkpointOf(progress, 0.2, kStep);
    const CellValues values = cellValues(volume, grid, checkpoint);
    markers.blood = bloodPools(values.mean, grid, int(kCoreShare * bloodHu), checkpoint);
    markers.bone = boneCells(values, grid, checkpoint);
    markers.lung = insideLungs(volume, grid, partOf(progress, 0.3, 0.5), checkpointOf(progress, 0.5, kStep));
    const std::vector<float> fromBlood = squaredDistances(markers.blood, 1, grid, kBesideMm, checkpoint);
    const Cells veins = undilutedVeins(values, markers, fromBlood, bloodHu, checkpoint);
    const Cells rims = widened(veins, grid, kRimMm, checkpoint);
    for (std::size_t i = 0; i < markers.bone.size(); ++i) {  // what is as dense as bone in a lung is medium
        markers.bone[i] = markers.bone[i] && !markers.lung[i] && !rims[i] && atLeast(fromBlood[i], kBesideMm);
        markers.blood[i] |= veins[i];
    }
    return markers;
}

/// Calls mark(cell, place) for each voxel, on all processors, and writes what it returns.
template <class MarkOf>
void markVoxels(const CellGrid& grid, Marks& marks, const Checkpoint& checkpoint, const MarkOf& markOf) {
    const ivec3 size = grid.voxels;
    forEachSlice(size.z, checkpoint, [&](int z) {
        std::uint8_t* mark = marks.data() + std::size_t(z) * std::size_t(size.y) * std::size_t(size.x);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x, ++mark)
                *mark = markOf(grid.index(x / grid.block.x, y / grid.block.y, z / grid.block.z), ivec3(x, y, z), *mark);
    });
}

/// Returns whether a voxel in a lung is a vessel's: dense, and so is another one beside it, or else it is noise.
bool isLungVessel(const Volume& volume, ivec3 at) {
    if (smoothedAt(volume, at) <= kLungVesselHu)
        return false;
    for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
            ivec3 there = at;
            there[axis] = std::clamp(at[axis] + step, 0, volume.size()[axis] - 1);
            if (there != at && smoothedAt(volume, there) > kLungVesselHu)
                return true;
        }
    return false;
}

Result<LabelMap> vesselsWith(const Volume& volume, float bloodHu, const Progress& progress) {
    const Markers markers = markersOf(volume, bloodHu, progress);
    if (std::ranges::find(markers.blood, 1) == markers.blood.end())
        return refused(phrase("there is no pool of 5 ml of blood with contrast medium"));
    const int least = std::clamp(int(kVesselShare * bloodHu), kLeastHu, kMostHu);
    const int bone = std::max(kBoneHu, int(kBoneShare * bloodHu));
    Marks marks(volume.voxels().size());
    const Checkpoint atMarks = checkpointOf(progress, 0.6, kStep);
    markVoxels(markers.grid, marks, atMarks, [&](std::size_t cell, ivec3 at, std::uint8_t) {
        const int hu = smoothedAt(volume, at);
        if (hu < least)
            return kWall;
        return markers.blood[cell] ? kBlood : markers.bone[cell] && hu > bone ? kBone : kOpen;
    });
    flood(volume, marks, checkpointOf(progress, 0.8, kStep));
    markVoxels(markers.grid, marks, checkpointOf(progress, 0.9, kStep),
               [&](std::size_t cell, ivec3 at, std::uint8_t mark) {
                   const bool isInLung = markers.lung[cell] && isLungVessel(volume, at);
                   return std::uint8_t(mark == kBlood || isInLung);
               });
    LabelMap map;
    map.geometry = volume.geometry();
    map.labels = std::move(marks);
    map.parts = {{"vessels", {200, 40, 40}}};
    map.source = phrase("a rule of this program");
    map.notes = {
        phrase("vessels are guessed by their density: check them; beside bone (neck, base of the skull) they "
               "may be missing, as may veins full of undiluted medium; calcium, and organs full of medium, may be "
               "among them")};
    return map;
}

}  // namespace

Result<LabelMap> findVessels(const Volume& volume, const Progress& progress) {
    if (!unitOf(volume).isHu)
        return refused(phrase("the values of this scan are no HU"));
    const std::optional<float> blood = findingsOn(volume, volume.geometry()).blood;
    if (!blood)
        return refused(phrase("no contrast medium is found in the blood"));
    if (*blood < kFaintestHu)
        return refused(phrase("the blood has %1 HU, which marrow has, too", numberOf(*blood, 3)));
    try {
        return orCancelled([&] { return vesselsWith(volume, *blood, progress); });
    } catch (const std::bad_alloc&) {
        return notEnoughMemoryForVoxels(volume.voxels().size(), "");
    }
}

}  // namespace pdr::segment
