#include "render/segment/body_parts.h"

#include <algorithm>
#include <cstdio>
#include <new>
#include <string>
#include <utility>

#include "render/base/errors.h"
#include "render/segment/body_mask.h"
#include "render/segment/bone_cells.h"
#include "render/segment/distance.h"
#include "render/segment/pieces.h"
#include "render/segment/smooth_distance.h"

namespace pdr::segment {
namespace {

constexpr std::string_view kStep = "finding the part to show";
constexpr double kRoomMm = 6;  ///< beyond an edge: for its ramp and for smoothing

constexpr int kAirHu = -400;         ///< below it a cell may be lung
constexpr int kGasHu = -970;         ///< below it bowel gas, above it lung
constexpr double kLungMl = 150;      ///< of a lung, at least
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

/// The pieces of air that are lungs.
Cells lungCells(const Volume& volume, const BodyMask& body) {
    const CellGrid& grid = body.grid;
    Cells air = cellsAbove(kAirHu, volume, grid);
    for (std::size_t i = 0; i < air.size(); ++i)
        air[i] = body.body[i] && !air[i];
    const Cells tissue = cellsAbove(kGasHu, volume, grid);
    const Pieces pieces = piecesOf(air, grid);
    std::vector<std::size_t> size(std::size_t(pieces.count) + 1), notGas(size.size());
    for (std::size_t i = 0; i < air.size(); ++i) {
        ++size[std::size_t(pieces.of[i])];
        notGas[std::size_t(pieces.of[i])] += tissue[i];
    }
    Cells lung(air.size());
    for (std::size_t i = 0; i < air.size(); ++i) {
        const auto piece = std::size_t(pieces.of[i]);
        lung[i] = air[i] && double(size[piece]) * grid.cellMl() >= kLungMl && 2 * notGas[piece] > size[piece];
    }
    return lung;
}

bool none(const Cells& cells) {
    return std::find(cells.begin(), cells.end(), 1) == cells.end();
}

/// The mask of all that lies at least `edgeMm` from where `distance` counts from.
std::shared_ptr<const Mask> beyond(const SmoothDistance& distance, double edgeMm, const Volume& volume,
                                   std::string hidden) {
    return maskOf(MaskGrid::over(volume.geometry()), std::move(hidden),
                  [&](dvec3 place) { return edgeWeight(distance.at(place) - edgeMm); });
}

std::string lengthText(double mm) {
    char text[40];
    std::snprintf(text, sizeof text, "%g mm", mm);
    return text;
}

}  // namespace

PartMask peeled(const Volume& volume, double depthMm, const Progress& progress) {
    const Result<BodyMask> body = bodyMask(volume, partOf(progress, 0, 0.6));
    if (!body)
        return without(body.error(), "nothing can be peeled off");
    const SmoothDistance depth(body->body, 0, body->grid, depthMm + kRoomMm);
    if (!progress(0.9, kStep))
        return cancelled();
    return beyond(depth, depthMm, volume,
                  "Peeled " + lengthText(depthMm) + ": skin and what lies less deep is not shown.");
}

PartMask lungs(const Volume& volume, const Progress& progress) {
    const Result<BodyMask> body = bodyMask(volume, partOf(progress, 0, 0.5));
    if (!body)
        return without(body.error(), "the lungs cannot be told from the rest");
    Cells wide = lungCells(volume, *body);
    if (none(wide))
        return refused("the lungs cannot be shown", "there is no air of 150 ml in the body that looks like a lung");
    if (!progress(0.6, kStep))
        return cancelled();
    const std::vector<float> distances = squaredDistances(wide, 1, body->grid, kVesselMm);
    for (std::size_t i = 0; i < wide.size(); ++i)
        wide[i] = atMost(distances[i], kVesselMm);
    if (!progress(0.7, kStep))
        return cancelled();
    const SmoothDistance depth(wide, 0, body->grid, kVesselMm + kPleuraMm + kRoomMm);
    if (!progress(0.9, kStep))
        return cancelled();
    return beyond(depth, kVesselMm + kPleuraMm, volume,
                  "Only the lungs are shown; " + lengthText(kPleuraMm) + " at the pleura are missing.");
}

PartMask bones(const Volume& volume, Bones wanted, const Progress& progress) {
    if (!progress(0, kStep))
        return cancelled();
    const CellGrid grid = CellGrid::over(volume.geometry());
    const Cells bone = boneCells(volume, grid);
    if (none(bone))
        return refused("bones cannot be told from the rest", "nothing in the scan is as dense as bone");
    if (!progress(0.7, kStep))
        return cancelled();
    const SmoothDistance away(bone, 1, grid, kAroundBoneMm + kRoomMm);
    if (!progress(0.9, kStep))
        return cancelled();
    if (wanted == Bones::hidden)
        return beyond(away, kAroundBoneMm, volume,
                      "Bones are not shown, nor is what lies within 2 mm of them; dense vessels may be missing with "
                      "them.");
    return maskOf(MaskGrid::over(volume.geometry()), "Only bones are shown, as far as they hold dense bone.",
                  [&](dvec3 place) { return edgeWeight(kAroundBoneMm - away.at(place)); });
}

}  // namespace pdr::segment
