#pragma once
/// The place of one slice, and whether two can share a grid. Pure geometry: independent of files, tags and pixels.

#include <optional>
#include <string>

#include "render/base/portable.h"
#include "render/base/text.h"

namespace pdr::dicom {

/// Largest distance [mm] of a pixel of one slice from where the other's grid would put it, if they share a grid:
/// scanners that write directions and spacings anew for each slice err by less, and it is a fraction of any pixel.
inline constexpr double kGridToleranceMm = 0.2;
/// Largest difference of spacings (relative) and directions (any component) of slices that share a grid, however small.
inline constexpr double kGridTolerance = 1e-3;
/// Largest deviation of the direction cosines from length one and from a right angle.
inline constexpr double kUnitTolerance = 1e-3;

/// The place of a slice. `name` is what messages call it; lengths in mm, patient space LPS.
struct SlicePlane {
    std::string name;
    ivec2 size{0};  ///< columns, rows
    std::optional<dvec3> position, rowDirection, columnDirection;
    std::optional<dvec2> spacingMm;  ///< x: between columns, y: between rows
};

/// Returns a sentence that says what is missing or unusable to place the slice; empty if nothing is.
Text missingGeometry(const SlicePlane& slice);

/// Returns how far the pixel at the far corner of `b` lies from where `a`'s spacing and directions would put it, both
/// starting from one first pixel [mm]. Both must have geometry.
double gridDeviationMm(const SlicePlane& a, const SlicePlane& b);
bool sameDirection(const SlicePlane& a, const SlicePlane& b);
bool sameSpacing(const SlicePlane& a, const SlicePlane& b);
/// Returns whether two slices have equal sizes and agree within the tolerances above; without geometry, the sizes
/// decide.
bool sameGrid(const SlicePlane& a, const SlicePlane& b);

/// Formats a length: "0.793", "5": up to three decimals, no trailing zeros.
Text inMm(double value);
/// Formats the size of a slice: "512 x 512 pixels of 0.7 mm x 0.7 mm".
Text sizeText(const SlicePlane& slice);

}  // namespace pdr::dicom
