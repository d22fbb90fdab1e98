#include "render/segment/body_parts.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "render/base/errors.h"
#include "render/base/text.h"
#include "render/segment/bone_cells.h"
#include "render/segment/distance.h"
#include "render/segment/for_each_slice.h"
#include "render/segment/labels.h"
#include "render/segment/lung_cells.h"
#include "render/volume/value_unit.h"

namespace pdr::segment {
namespace {

constexpr std::string_view kStep = "separating the body parts";
constexpr double kRoomMm = 6;      ///< distance known beyond an edge: for its ramp and for smoothing
constexpr double kShallowMm = 20;  ///< most peels are shallower
constexpr double kDeepMm = 50;

constexpr double kVesselMm = 8;      ///< radius of the vessels that belong to a lung
constexpr double kPleuraMm = 5;      ///< outermost layer of a lung, which is not shown
constexpr double kAroundBoneMm = 2;  ///< surface layer of a bone, which is half as dense as bone

Error refused(const Text& what, const Text& why) {
    return {phrase("%1, because %2", what, why), "", phrase("Show everything, or another part."), ErrorKind::refused};
}

/// Returns the error for `what`, which needs a body that bodyMask() refused to identify; other errors as they are.
Error without(const Error& error, const Text& what) {
    return error.kind == ErrorKind::refused ? refused(what, error.what) : error;
}

bool none(const Cells& cells) {
    return std::find(cells.begin(), cells.end(), 1) == cells.end();
}

/// Returns the stored value, which `find` computes the first time.
template <typename T, typename Find>
Result<std::shared_ptr<const T>> knownOr(Found<T>& found, const Find& find) {
    const std::lock_guard lock(found.mutex);
    if (!found.value) {
        Result<T> now = orCancelled(find);
        if (!now)
            return now.error();
        found.value = std::make_shared<const T>(*std::move(now));
    }
    return found.value;
}

/// Drops the stored value, unless a thread is computing it right now.
template <typename T>
void forget(Found<T>& found) {
    if (const std::unique_lock lock(found.mutex, std::try_to_lock); lock)
        found.value.reset();
}

/// Returns the distances at the nodes of a mask, row by row.
class RowOfDistances {
  public:
    /// Reads `distance` of a volume with the geometry `own`, for a mask of one with the geometry `on`.
    RowOfDistances(const SmoothDistance& distance, const VolumeGeometry& own, const VolumeGeometry& on,
                   const MaskGrid& grid)
        : distance_(distance),
          grid_(grid),
          same_(on.patientFromIndex == own.patientFromIndex),
          placeInVolume_(glm::inverse(own.patientFromIndex) * on.patientFromIndex) {}

    void operator()(int j, int k, std::vector<double>& mm) const {
        if (same_)
            return distance_.along(ivec3(grid_.place({0, j, k})), 1 << grid_.shift.x, int(mm.size()), mm.data());
        for (int i = 0; i < int(mm.size()); ++i)
            mm[std::size_t(i)] = distance_.at(dvec3(placeInVolume_ * dvec4(grid_.place({i, j, k}), 1.0)));
    }

  private:
    const SmoothDistance& distance_;
    const MaskGrid& grid_;
    bool same_;
    dmat4 placeInVolume_;
};

}  // namespace

Result<std::shared_ptr<const BodyMask>> BodyParts::body(const Progress& progress) const {
    return knownOr(body_, [&] {
        Result<BodyMask> mask = bodyMask(*volume_, progress);
        if (mask)
            mask->shown = mask->cut = {};
        return mask;
    });
}

BodyParts::Distance BodyParts::belowSkin(double depthMm, const Progress& progress) const {
    const bool shallow = depthMm <= kShallowMm;
    forget(shallow ? deepBelowSkin_ : belowSkin_);
    return knownOr(shallow ? belowSkin_ : deepBelowSkin_, [&]() -> Result<SmoothDistance> {
        const auto whole = body(partOf(progress, 0, 0.8));
        if (!whole)
            return whole.error();
        return SmoothDistance((*whole)->body, 0, (*whole)->grid, (shallow ? kShallowMm : kDeepMm) + kRoomMm,
                              checkpointOf(progress, 0.9, kStep));
    });
}

void BodyParts::forgetDistances() const {
    for (Found<SmoothDistance>* found : {&belowSkin_, &deepBelowSkin_, &inLungs_, &fromBones_})
        forget(*found);
}

BodyParts::FoundCells BodyParts::aroundLungs(const BodyMask& body, const Progress& progress) const {
    return knownOr(aroundLungs_, [&]() -> Result<Cells> {
        const Cells lungs = lungCells(*volume_, body, checkpointOf(progress, 0, kStep));
        if (none(lungs))
            return refused(phrase("the lungs cannot be shown"),
                           phrase("there is no air of 150 ml in the body that looks like a lung"));
        return widened(lungs, body.grid, kVesselMm, checkpointOf(progress, 0.5, kStep));
    });
}

BodyParts::Distance BodyParts::inLungs(const Progress& progress) const {
    forget(fromBones_);
    return knownOr(inLungs_, [&]() -> Result<SmoothDistance> {
        const auto whole = body(partOf(progress, 0, 0.6));
        if (!whole)
            return without(whole.error(), phrase("the lungs cannot be told from the rest"));
        const FoundCells wide = aroundLungs(**whole, partOf(progress, 0.6, 0.9));
        if (!wide)
            return wide.error();
        return SmoothDistance(**wide, 0, (*whole)->grid, kVesselMm + kPleuraMm + kRoomMm,
                              checkpointOf(progress, 0.9, kStep));
    });
}

BodyParts::FoundCells BodyParts::cellsOfBones(const CellGrid& grid, const Progress& progress) const {
    return knownOr(bones_, [&]() -> Result<Cells> {
        if (!unitOf(*volume_).isHu)
            return refused(phrase("bones cannot be told from the rest"), phrase("the values of this scan are no HU"));
        Cells bone = boneCells(*volume_, grid, checkpointOf(progress, 0, kStep));
        if (none(bone))
            return refused(phrase("bones cannot be told from the rest"),
                           phrase("nothing in the scan is as dense as bone"));
        return bone;
    });
}

BodyParts::Distance BodyParts::fromBones(const Progress& progress) const {
    forget(inLungs_);
    return knownOr(fromBones_, [&]() -> Result<SmoothDistance> {
        const CellGrid grid = CellGrid::over(volume_->geometry());
        const FoundCells bone = cellsOfBones(grid, partOf(progress, 0, 0.8));
        if (!bone)
            return bone.error();
        return SmoothDistance(**bone, 1, grid, kAroundBoneMm + kRoomMm, checkpointOf(progress, 0.8, kStep));
    });
}

/// Returns the mask with the weights weightOf(distance [mm]).
template <typename WeightOf>
PartMask BodyParts::maskOn(const VolumeGeometry& on, const Distance& distance, Text hidden, const Progress& progress,
                           const WeightOf& weightOf) const {
    if (!distance)
        return distance.error();
    const MaskGrid grid = MaskGrid::over(on);
    const ivec3 size = grid.size();
    HugePageVector<std::int16_t> weights(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    const RowOfDistances rowOf(**distance, volume_->geometry(), on, grid);
    return orCancelled([&]() -> PartMask {
        forEachSlice(size.z, checkpointOf(progress, 0.9, kStep), [&](int k) {
            std::vector<double> row(std::size_t(size.x));
            std::int16_t* weight = weights.data() + std::size_t(k) * std::size_t(size.y) * std::size_t(size.x);
            for (int j = 0; j < size.y; ++j, weight += size.x) {
                rowOf(j, k, row);
                std::transform(row.begin(), row.end(), weight, weightOf);
            }
        });
        return std::make_shared<const Mask>(grid, std::move(weights), std::move(hidden));
    });
}

PartMask BodyParts::peeled(double depthMm, const VolumeGeometry& on, const Progress& progress) const {
    const Distance distance = belowSkin(depthMm, partOf(progress, 0, 0.8));
    if (!distance)
        return without(distance.error(), phrase("nothing can be peeled off"));
    return maskOn(on, distance, phrase("Peeled %1 mm: skin and what lies less deep is not shown.", numberOf(depthMm)),
                  progress, [&](double mm) { return edgeWeight(mm - depthMm); });
}

PartMask BodyParts::lungs(Use use, const VolumeGeometry& on, const Progress& progress) const {
    const Distance distance = inLungs(partOf(progress, 0, 0.8));
    if (use == Use::shown)
        return maskOn(on, distance,
                      phrase("Only the lungs are shown; %1 mm at the pleura are missing.", numberOf(kPleuraMm)),
                      progress, [](double mm) { return edgeWeight(mm - kVesselMm - kPleuraMm); });
    return maskOn(on, distance, phrase("The lungs are not shown; %1 mm at the pleura remain.", numberOf(kPleuraMm)),
                  progress, [](double mm) { return edgeWeight(kVesselMm + kPleuraMm - mm); });
}

PartMask BodyParts::bones(Use use, const VolumeGeometry& on, const Progress& progress) const {
    const Distance distance = fromBones(partOf(progress, 0, 0.8));
    if (use == Use::shown)
        return maskOn(on, distance, phrase("Only bones are shown, as far as they hold dense bone."), progress,
                      [](double mm) { return edgeWeight(kAroundBoneMm - mm); });
    return maskOn(on, distance,
                  phrase("Bones are not shown, nor is what lies within 2 mm of them; dense vessels may be missing with "
                         "them."),
                  progress, [](double mm) { return edgeWeight(mm - kAroundBoneMm); });
}

PartMask BodyParts::labelled(std::string_view label, Use use, const VolumeGeometry& on,
                             const Progress& progress) const {
    if (label == kBones)
        return bones(use, on, progress);
    if (label == kLungs)
        return lungs(use, on, progress);
    return Error{phrase("this scan has no part called \"%1\"", std::string(label)), "",
                 phrase("Known parts: %1.", listed(Labels(std::begin(kFoundLabels), std::end(kFoundLabels)))),
                 ErrorKind::refused};
}

}  // namespace pdr::segment
