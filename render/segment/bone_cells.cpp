#include "render/segment/bone_cells.h"

#include <algorithm>

#include "render/segment/blood_cells.h"
#include "render/segment/cell_values.h"
#include "render/segment/distance.h"
#include "render/segment/for_each_slice.h"
#include "render/segment/pieces.h"

namespace pdr::segment {
namespace {

constexpr int kEvenFromHu = 300;  ///< least value of blood with contrast medium
constexpr int kVesselHu = 200;    ///< least value of a vessel's rim
constexpr double kVesselRimMm = 4;
constexpr int kDenseHu = 600;
constexpr double kLeastMl = 0.3;
constexpr int kMarrowHu = 150;
constexpr double kReachMm = 12;
constexpr double kClosedMm = 4;

Cells bloodCells(const std::vector<std::int16_t>& mean, const CellGrid& grid, const Checkpoint& checkpoint) {
    Cells blood = bloodPools(mean, grid, kEvenFromHu, checkpoint);
    // Extend them to the vessels' rims
    blood = widened(blood, grid, kVesselRimMm, checkpoint);
    for (std::size_t i = 0; i < blood.size(); ++i)
        blood[i] = blood[i] && mean[i] > kVesselHu;
    return blood;
}

/// Returns `cells` with all gaps filled that a ball of `radiusMm` does not fit into.
Cells closed(const Cells& cells, const CellGrid& grid, double radiusMm, const Checkpoint& checkpoint) {
    Cells wide = widened(cells, grid, radiusMm, checkpoint);
    const std::vector<float> distances = squaredDistances(wide, 0, grid, radiusMm, checkpoint);
    for (std::size_t i = 0; i < cells.size(); ++i)
        wide[i] = cells[i] || (wide[i] && !atMost(distances[i], radiusMm));
    return wide;
}

}  // namespace

Cells boneCells(const Volume& volume, const CellGrid& grid, const Checkpoint& checkpoint) {
    return boneCells(cellValues(volume, grid, checkpoint), grid, checkpoint);
}

Cells boneCells(const CellValues& values, const CellGrid& grid, const Checkpoint& checkpoint) {
    const Cells blood = bloodCells(values.mean, grid, checkpoint);
    const double least = kLeastMl / grid.cellMl();
    // Find pieces of dense bone
    Cells dense(blood.size());
    for (std::size_t i = 0; i < dense.size(); ++i)
        dense[i] = values.highest[i] > kDenseHu && values.mean[i] > kMarrowHu && !blood[i];
    checkpoint();
    dense = piecesWith(dense, least, dense, grid);
    // Extend them to connected cells of lower density, and close gaps
    Cells bone = widened(dense, grid, kReachMm, checkpoint);
    for (std::size_t i = 0; i < bone.size(); ++i)
        bone[i] = bone[i] && values.mean[i] > kMarrowHu && !blood[i];
    checkpoint();
    bone = closed(piecesWith(dense, 1, bone, grid), grid, kClosedMm, checkpoint);
    for (std::size_t i = 0; i < bone.size(); ++i)
        bone[i] = bone[i] && !blood[i];
    return bone;
}

}  // namespace pdr::segment
