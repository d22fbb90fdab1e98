#pragma once
/// From where the slices lie to what they are as a stack. Pure geometry: knows no file, no tag, no pixel.
///   lengths  millimetres, patient space LPS        normal  row direction x column direction
///
/// Tolerances, and why:
///   position    0.02 mm off the even grid. Positions are decimal strings; writers that keep two decimals err by
///               0.01 mm at the most (both ends of a distance rounded), and no surgeon sees a fiftieth of a millimetre.
///   drift       the same, plus 1e-4 of the distance travelled along the normal: direction cosines that were rounded to
///               four decimals turn the normal by that much.
///   direction   2e-4 in any component between slices of one stack (again four decimals).
///   unit        1e-3: how far the direction cosines may be from length one and from a right angle.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dicom/series.h"

namespace pdr::dicom {

inline constexpr double kPositionToleranceMm = 0.02;
inline constexpr double kDriftTolerance = 1e-4;
inline constexpr double kDirectionTolerance = 2e-4;
inline constexpr double kUnitTolerance = 1e-3;

/// Where one slice lies. `name` is what messages call it.
struct SlicePlane {
    std::string name;
    ivec2 size{0};  ///< columns, rows
    std::optional<dvec3> position, rowDirection, columnDirection;
    std::optional<dvec2> spacingMm;  ///< x: between columns, y: between rows
};

struct StackAnalysis {
    GeometryVerdict verdict;
    /// Indices of the slices, ascending along the normal of the first; as given where one has no geometry.
    std::vector<int> order;
    /// Complete for Stack::even; otherwise only `size`, and that only where the slices agree on it.
    VolumeGeometry geometry;
    /// Pairs at the same position (each with the first one there): copies, or two different pictures.
    std::vector<std::pair<int, int>> samePlace;
};

/// `slices` holds at least one.
StackAnalysis analyseStack(const std::vector<SlicePlane>& slices);

/// Parts slices of one series into those that can share a grid (same size, spacing and directions).
/// Parts with one slice only are gathered in one last part. Indices, in the order given.
std::vector<std::vector<int>> splitByGrid(const std::vector<SlicePlane>& slices);

}  // namespace pdr::dicom
