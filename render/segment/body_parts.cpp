#include "render/segment/body_parts.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "render/base/errors.h"
#include "render/segment/bone_cells.h"
#include "render/segment/distance.h"
#include "render/segment/lung_cells.h"

namespace pdr::segment {
namespace {

constexpr std::string_view kStep = "finding the part to show";
constexpr double kRoomMm = 6;      ///< beyond an edge: for its ramp and for smoothing
constexpr double kShallowMm = 20;  ///< most is peeled less deep
constexpr double kDeepMm = 50;

constexpr double kVesselMm = 8;      ///< radius of the vessels that belong to a lung
constexpr double kPleuraMm = 5;      ///< not shown
constexpr double kAroundBoneMm = 2;  ///< the skin of a bone, which is half as dense as bone

Error refused(const std::string& what, const std::string& why) {
    return {what + ", because " + why, "", "Show everything, or another part.", ErrorKind::refused};
}

/// Why a body that cannot be told keeps `what` from being done.
Error without(const Error& error, const std::string& what) {
    return error.kind == ErrorKind::refused ? refused(what, error.what) : error;
}

bool none(const Cells& cells) {
    return std::find(cells.begin(), cells.end(), 1) == cells.end();
}

std::string lengthText(double mm) {
    char text[40];
    std::snprintf(text, sizeof text, "%g mm", mm);
    return text;
}

/// What `find` finds, or what was found before.
template <typename T, typename Find>
Result<std::shared_ptr<const T>> knownOr(Found<T>& found, const Find& find) {
    const std::lock_guard lock(found.mutex);
    if (!found.value) {
        Result<T> now = find();
        if (!now)
            return now.error();
        found.value = std::make_shared<const T>(*std::move(now));
    }
    return found.value;
}

}  // namespace

Result<std::shared_ptr<const BodyMask>> BodyParts::body(const Progress& progress) const {
    return knownOr(body_, [&] { return bodyMask(*volume_, progress); });
}

BodyParts::Distance BodyParts::belowSkin(double depthMm, const Progress& progress) const {
    const bool shallow = depthMm <= kShallowMm;
    return knownOr(shallow ? belowSkin_ : deepBelowSkin_, [&]() -> Result<SmoothDistance> {
        const auto whole = body(progress);
        if (!whole)
            return whole.error();
        return SmoothDistance((*whole)->body, 0, (*whole)->grid, (shallow ? kShallowMm : kDeepMm) + kRoomMm);
    });
}

BodyParts::Distance BodyParts::inLungs(const Progress& progress) const {
    return knownOr(inLungs_, [&]() -> Result<SmoothDistance> {
        const auto whole = body(partOf(progress, 0, 0.6));
        if (!whole)
            return without(whole.error(), "the lungs cannot be told from the rest");
        const Cells lungs = lungCells(*volume_, **whole);
        if (none(lungs))
            return refused("the lungs cannot be shown", "there is no air of 150 ml in the body that looks like a lung");
        if (!progress(0.8, kStep))
            return cancelled();
        const CellGrid& grid = (*whole)->grid;
        const Cells wide = widened(lungs, grid, kVesselMm);
        if (!progress(0.9, kStep))
            return cancelled();
        return SmoothDistance(wide, 0, grid, kVesselMm + kPleuraMm + kRoomMm);
    });
}

BodyParts::Distance BodyParts::fromBones(const Progress& progress) const {
    return knownOr(fromBones_, [&]() -> Result<SmoothDistance> {
        if (!progress(0, kStep))
            return cancelled();
        const CellGrid grid = CellGrid::over(volume_->geometry());
        const Cells bone = boneCells(*volume_, grid);
        if (none(bone))
            return refused("bones cannot be told from the rest", "nothing in the scan is as dense as bone");
        if (!progress(0.8, kStep))
            return cancelled();
        return SmoothDistance(bone, 1, grid, kAroundBoneMm + kRoomMm);
    });
}

/// Seen is what weightOf(distance [mm]) says.
template <typename WeightOf>
PartMask BodyParts::maskOn(const VolumeGeometry& on, const Distance& distance, std::string hidden,
                           const Progress& progress, const WeightOf& weightOf) const {
    if (!distance)
        return distance.error();
    if (!progress(0.9, kStep))
        return cancelled();
    const dmat4& own = volume_->geometry().patientFromIndex;
    const dmat4 placeInVolume = on.patientFromIndex == own ? dmat4(1.0) : glm::inverse(own) * on.patientFromIndex;
    return maskOf(MaskGrid::over(on), std::move(hidden),
                  [&](dvec3 place) { return weightOf((*distance)->at(dvec3(placeInVolume * dvec4(place, 1.0)))); });
}

PartMask BodyParts::peeled(double depthMm, const VolumeGeometry& on, const Progress& progress) const {
    const Distance distance = belowSkin(depthMm, partOf(progress, 0, 0.8));
    if (!distance)
        return without(distance.error(), "nothing can be peeled off");
    return maskOn(on, distance, "Peeled " + lengthText(depthMm) + ": skin and what lies less deep is not shown.",
                  progress, [&](double mm) { return edgeWeight(mm - depthMm); });
}

PartMask BodyParts::lungs(const VolumeGeometry& on, const Progress& progress) const {
    return maskOn(on, inLungs(partOf(progress, 0, 0.8)),
                  "Only the lungs are shown; " + lengthText(kPleuraMm) + " at the pleura are missing.", progress,
                  [](double mm) { return edgeWeight(mm - kVesselMm - kPleuraMm); });
}

PartMask BodyParts::bones(Bones wanted, const VolumeGeometry& on, const Progress& progress) const {
    const Distance distance = fromBones(partOf(progress, 0, 0.8));
    if (wanted == Bones::shown)
        return maskOn(on, distance, "Only bones are shown, as far as they hold dense bone.", progress,
                      [](double mm) { return edgeWeight(kAroundBoneMm - mm); });
    return maskOn(on, distance,
                  "Bones are not shown, nor is what lies within 2 mm of them; dense vessels may be missing with them.",
                  progress, [](double mm) { return edgeWeight(mm - kAroundBoneMm); });
}

}  // namespace pdr::segment
