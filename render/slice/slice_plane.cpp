#include "render/slice/slice_plane.h"

namespace pdr {

SlicePlane SlicePlane::around(dvec3 middleMm, dvec3 right, dvec3 down, double mmPerPixel, ivec2 size) {
    SlicePlane plane{dvec3(0), right, down, mmPerPixel, size};
    plane.originMm = middleMm - plane.middleMm();
    return plane;
}

SlicePlane SlicePlane::behind(double mm) const {
    SlicePlane moved = *this;
    moved.originMm += mm * normal();
    return moved;
}

dvec2 SlicePlane::pixelAt(dvec3 mm) const {
    const dvec3 fromOrigin = (mm - originMm) / mmPerPixel;
    return {glm::dot(fromOrigin, right), glm::dot(fromOrigin, down)};
}

}  // namespace pdr
