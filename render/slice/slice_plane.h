#pragma once
/// The place of a slice in the patient: a plane with square pixels.
///   lengths  millimetres, patient space LPS        pixel (x, y)  x to the right, y down, centred at mmAt({x, y})

#include "render/base/portable.h"

namespace pdr {

struct SlicePlane {
    dvec3 originMm{0};      ///< centre of pixel (0, 0), the upper left one
    dvec3 right{1, 0, 0};   ///< unit vector along a row
    dvec3 down{0, 1, 0};    ///< unit vector along a column, perpendicular to `right`
    double mmPerPixel = 1;  ///< distance between the centres of neighbouring pixels, > 0
    ivec2 size{0};          ///< pixels

    /// Returns the plane with these directions whose middle is `middleMm`.
    static SlicePlane around(dvec3 middleMm, dvec3 right, dvec3 down, double mmPerPixel, ivec2 size);
    /// Returns the parallel plane that lies `mm` further away from the viewer.
    SlicePlane behind(double mm) const;

    /// Returns the unit vector across the plane, away from the viewer.
    dvec3 normal() const { return glm::cross(right, down); }
    /// Returns the middle of the pixels: a corner of four of them where their number is even.
    dvec3 middleMm() const { return mmAt(dvec2(size - 1) / 2.0); }

    /// Returns the place of a pixel, or of a place between pixels.
    dvec3 mmAt(dvec2 pixel) const { return originMm + mmPerPixel * (pixel.x * right + pixel.y * down); }
    /// Returns the pixel, with fractions, on which a place lies when seen along the normal.
    dvec2 pixelAt(dvec3 mm) const;
    /// Returns how far a place lies behind the plane; negative: before it.
    double depthMm(dvec3 mm) const { return glm::dot(mm - originMm, normal()); }

    bool operator==(const SlicePlane&) const = default;
};

}  // namespace pdr
