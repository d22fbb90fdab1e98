#pragma once
/// A plan with one measurement of each sort that tables and files must tell apart, and its scan.

#include "app/plan/plan_file.h"

namespace pdr::test {

/// Returns a scan whose HU are a sawtooth, on voxels of 0.9 x 0.9 x 2.5 mm.
inline Volume scanOfMarks() {
    const auto grid = VolumeGeometry::aligned({64, 57, 64}, {0.9, 0.9, 2.5}, {-28.8, -25.65, -80});
    Voxels voxels(grid.voxelCount());
    for (std::size_t n = 0; n < voxels.size(); ++n)
        voxels[n] = std::int16_t(n * 7 % 101);
    return {grid, std::move(voxels)};
}

/// Returns a place that was clicked on an axial slice.
inline measure::Place onSlice(dvec3 mm) {
    return measure::clickedPlace(scanOfMarks().geometry(), mm, {{1, 0, 0}, {0, 1, 0}, 0.5, 0});
}

/// Returns a place at an edge across x, 1.5 mm wide.
inline measure::Place atEdge(dvec3 mm) {
    return measure::movedToEdge(onSlice(mm), mm, {1, 0, 0}, 0.05, 0.1, 1.5);
}

/// Returns an estimate with a ±, a thin plate, typed places, an angle near 180 degrees, one that does not exist, two
/// lines, the HU of a place, and those of a ball, of an ellipse, a polygon, and of a ball that holds no voxel.
inline app::Plan someMarks() {
    using app::MeasureKind;
    const auto typed = measure::typedPlace;
    app::Plan plan;
    plan.image.look.transferFunction.nodes = {{0, 0}};
    plan.measurements = {
        {11, MeasureKind::distance, "", {onSlice({-13.25, -20, 4}), onSlice({17.5, -8.125, 4})}},
        {12, MeasureKind::distance, "=2+3", {atEdge({-1, 0, 9}), atEdge({0.5, 0, 9})}},
        {13, MeasureKind::distance, "Größe, \"alt\"", {typed({1, 2, 3}), typed({4, 6, 3})}},
        {14, MeasureKind::angle, "", {onSlice({-20, 0, 4}), onSlice({0, 0.5, 4}), onSlice({20, 0, 4})}},
        {15, MeasureKind::angle, "'quoted'\nname", {onSlice({5, 5, 4}), onSlice({5, 5, 4}), onSlice({20, 0, 4})}},
        {16,
         MeasureKind::lines,
         "",
         {onSlice({0, 0, 4}), onSlice({20, 2, 4}), onSlice({0, -10, 4}), onSlice({15, -4, 4})}},
        {17, MeasureKind::point, "aorta", {onSlice({3, 4, 5})}},
        {18, MeasureKind::ball, "", {onSlice({0, 0, 4}), onSlice({8, 0, 4})}},
        {19, MeasureKind::ellipse, "", {onSlice({0, 0, 4}), onSlice({9, 0, 4}), onSlice({0, 6, 4})}},
        {20,
         MeasureKind::polygon,
         "",
         {onSlice({-9, -9, 4}), onSlice({9, -9, 4}), onSlice({9, 9, 4}), onSlice({0, 0, 4}), onSlice({-9, 9, 4})}},
        {18446744073709551615u, MeasureKind::ball, "", {onSlice({0, 0, 4.9}), onSlice({0.1, 0, 4.9})}},
    };
    return plan;
}

}  // namespace pdr::test
