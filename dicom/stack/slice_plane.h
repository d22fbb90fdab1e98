#pragma once
/// Where one slice lies, and whether two can share a grid. Pure geometry: knows no file, no tag, no pixel.

#include <optional>
#include <string>

#include "render/base/portable.h"
#include "render/base/text.h"

namespace pdr::dicom {

/// Slices share a grid where no pixel of one lies further than this from where the other's grid would put it: scanners
/// that write directions and spacings anew for each slice err by less, and it is a fraction of any pixel.
inline constexpr double kGridToleranceMm = 0.2;
/// ... and where spacings (relative) and directions (any component) agree within this, however small the slices are.
inline constexpr double kGridTolerance = 1e-3;
/// How far the direction cosines may be from length one and from a right angle.
inline constexpr double kUnitTolerance = 1e-3;

/// `name` is what messages call it; lengths in mm, patient space LPS.
struct SlicePlane {
    std::string name;
    ivec2 size{0};  ///< columns, rows
    std::optional<dvec3> position, rowDirection, columnDirection;
    std::optional<dvec2> spacingMm;  ///< x: between columns, y: between rows
};

/// Empty if the slice says all that is needed to place it; else a sentence.
Text missingGeometry(const SlicePlane& slice);

/// How far the pixel at the far corner of `b` lies from where `a`'s spacing and directions would put it, from the same
/// first pixel [mm]. Both have geometry.
double gridDeviationMm(const SlicePlane& a, const SlicePlane& b);
bool sameDirection(const SlicePlane& a, const SlicePlane& b);
bool sameSpacing(const SlicePlane& a, const SlicePlane& b);
/// Equal size, and within the tolerances above; two slices without geometry share a grid where their sizes agree.
bool sameGrid(const SlicePlane& a, const SlicePlane& b);

/// "0.793", "5": up to three decimals, no trailing zeros.
Text inMm(double value);
/// "512 x 512 pixels of 0.7 mm x 0.7 mm"
Text sizeText(const SlicePlane& slice);

}  // namespace pdr::dicom
