#pragma once
/// Even slices between uneven ones: where a slice is missing, or zones of a stack differ in distance. No new slice lies
/// beyond the measured ones, and a measured slice that lies where a new one belongs is taken as it is.

#include <optional>
#include <vector>

#include "dicom/series.h"
#include "render/volume/holes.h"

namespace pdr::dicom {

struct EvenFill {
    double gapMm = 0;                    ///< distance of the new slices
    std::vector<SliceBlend> slices;      ///< from the lowest measured slice to the highest
    double furthestMm = 0;               ///< how far the new slice lies from the next measured one that lies furthest
    double closestMm = 0, widestMm = 0;  ///< the smallest and the widest gap between measured slices
    std::vector<HoleHeights> holes;      ///< between measured slices at least kHoleGaps new gaps apart; ascending
};

/// Limits of a fill. Beyond them, most of what would be shown was never measured.
inline constexpr double kLeastFillMm = 0.3;  ///< new slices lie no closer
inline constexpr int kMostFill = 4;          ///< new slices for each measured one
inline constexpr double kWidestHoleMm = 30;
inline constexpr double kWidestHoleGaps = 10;  ///< times the usual gap, the median

/// The least distance of two measured slices with a hole in between [gaps of the new slices]: one and a half, less what
/// rounding of positions takes away. The slices seem to be closer there than they were measured.
inline constexpr double kHoleGaps = 1.4;

/// Returns slices as close as the closest measured ones, within the limits; none if a hole is too wide. `heights`: of
/// the measured slices along their normal [mm], ascending, at least two, none at the place of another. `sameMm`: how
/// far a slice may lie from its place.
std::optional<EvenFill> evenFill(const std::vector<double>& heights, double sameMm);

}  // namespace pdr::dicom
