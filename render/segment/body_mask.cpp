#include "render/segment/body_mask.h"

#include <algorithm>
#include <cmath>

#include "render/base/errors.h"
#include "render/base/text.h"
#include "render/segment/cell_values.h"
#include "render/segment/checkpoint.h"
#include "render/segment/contact.h"
#include "render/segment/distance.h"
#include "render/segment/pieces.h"
#include "render/segment/rule.h"
#include "render/volume/value_unit.h"

namespace pdr::segment {
namespace {

constexpr std::string_view kStep = "looking for the table";

Error undecided(Text why) {
    return {std::move(why), "", "", ErrorKind::refused};
}

std::size_t countOf(const Cells& cells) {
    return std::size_t(std::count(cells.begin(), cells.end(), 1));
}

/// Returns the share of the cells at the four sides of the slices that belong to the body.
double shareOfBorder(const Cells& body, const CellGrid& grid) {
    std::size_t all = 0, covered = 0;
    const auto look = [&](int x, int y, int z) {
        ++all;
        covered += body[grid.index(x, y, z)];
    };
    for (int z = 0; z < grid.size.z; ++z) {
        for (int x = 0; x < grid.size.x; ++x)
            for (const int y : {0, grid.size.y - 1})
                look(x, y, z);
        for (int y = 0; y < grid.size.y; ++y)
            for (const int x : {0, grid.size.x - 1})
                look(x, y, z);
    }
    return double(covered) / double(all);
}

/// Returns the foreign cells that the body touches; none where the field of view cuts through the body, since lung
/// vessels reach its border there.
Cells foreignIn(const Cells& body, const std::vector<float>& squaredDepths, const CellGrid& grid,
                const Checkpoint& checkpoint) {
    if (shareOfBorder(body, grid) > kMostAtBorder)
        return Cells(body.size());
    return touching(body, squaredDepths, grid, checkpoint);
}

/// Returns the outline widened by a cell, without other solids.
Cells shownOf(const Cells& outline, const Cells& solid, const CellGrid& grid, const Checkpoint& checkpoint) {
    Cells shown = grown(outline, grid, checkpoint);
    for (std::size_t i = 0; i < shown.size(); ++i)
        shown[i] = shown[i] && (outline[i] || !solid[i]);
    return shown;
}

/// Finds the body; its checkpoints throw Stopped.
Result<BodyMask> findBody(const Volume& volume, const Progress& progress) {
    const dvec3 spacing = volume.geometry().spacingMm();
    if (glm::max(spacing.x, glm::max(spacing.y, spacing.z)) > kCoarsestMm)
        return undecided(phrase("voxels lie more than 5 mm apart"));
    BodyMask mask;
    // Find the bodies: connected solids that hold the ball
    const CellGrid& grid = mask.grid = CellGrid::over(volume.geometry());
    const Cells solid = cellsAbove(kSolidHu, cellSums(volume, grid, checkpointOf(progress, 0, kStep)), grid);
    const Checkpoint atDepths = checkpointOf(progress, 0.3, kStep);
    const std::vector<float> squaredDepths = squaredDistances(solid, 0, grid, kBallMm, atDepths);
    atDepths();
    ThickPieces bodies = thickPieces(solid, squaredDepths, grid, kBallMm, atDepths);
    atDepths();
    if (bodies.count == 0)
        return undecided(phrase("nothing is as thick as 20 mm"));
    if (double(countOf(bodies.cells)) < kLeastBody * double(countOf(solid)))
        return undecided(phrase("more than half of what is solid is thinner than 20 mm"));
    // Cut off what touches them
    const Checkpoint atContact = checkpointOf(progress, 0.5, kStep), atOutline = checkpointOf(progress, 0.8, kStep);
    Cells& body = bodies.cells;
    mask.cut = foreignIn(body, squaredDepths, grid, atContact);
    for (std::size_t i = 0; i < body.size(); ++i)
        body[i] = body[i] && !mask.cut[i];
    atOutline();
    // Fill the outline, and show it with a cell around
    mask.body = withHolesFilled(body, grid, atOutline);
    const Cells& outline = mask.body;
    atOutline();
    mask.shown = shownOf(outline, solid, grid, atOutline);
    atOutline();
    mask.box = boxOf(outline, grid);
    mask.rowEnds = rowEnds(outline, grid);
    mask.parts = bodies.count;
    mask.bodyMl = volumeMl(outline, grid);
    checkpointOf(progress, 1, kStep)();
    return mask;
}

}  // namespace

Result<BodyMask> bodyMask(const Volume& volume, const Progress& progress) {
    if (!unitOf(volume).isHu)
        return undecided(phrase("the values of this scan are no HU"));
    return orCancelled([&] { return findBody(volume, progress); });
}

}  // namespace pdr::segment
