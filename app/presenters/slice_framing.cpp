#include "app/presenters/slice_framing.h"

#include <algorithm>
#include <cmath>

#include "render/slice/slice_step.h"

namespace pdr::app {

SlicePlane framed(const SlicePlane& slice, const SliceFraming& framing, ivec2 pixels) {
    const dvec2 slicePixels = dvec2(slice.size), viewPixels = dvec2(glm::max(pixels, ivec2(1)));
    const dvec2 perPixel = slicePixels * slice.mmPerPixel / viewPixels;
    const double mmPerPixel = std::max(perPixel.x, perPixel.y) / framing.zoom;
    const dvec3 middle = slice.middleMm() + framing.panMm.x * slice.right + framing.panMm.y * slice.down;
    return SlicePlane::around(middle, slice.right, slice.down, mmPerPixel, ivec2(viewPixels));
}

SliceFraming zoomed(const SliceFraming& framing, const SlicePlane& slice, double factor, dvec3 placeMm) {
    SliceFraming zoomed = framing;
    zoomed.zoom = std::clamp(framing.zoom * factor, SliceFraming::kLeastZoom, SliceFraming::kGreatestZoom);
    const dvec3 offset = placeMm - slice.middleMm();
    const dvec2 fixed(glm::dot(offset, slice.right), glm::dot(offset, slice.down));
    zoomed.panMm = fixed + (framing.panMm - fixed) * (framing.zoom / zoomed.zoom);
    return zoomed;
}

int nearestSlice(const SliceStack& stack, dvec3 placeMm) {
    const dvec2 range = stack.rangeMm();
    const double index = (stack.positionMm(placeMm) - range.x) / (range.y - range.x) * stack.count();
    return std::clamp(int(std::floor(index)), 0, stack.count() - 1);
}

dvec3 stepped(const SliceStack& stack, dvec3 crosshairMm, int count) {
    const int index = std::clamp(nearestSlice(stack, crosshairMm) + count, 0, stack.count() - 1);
    const SlicePlane slice = stack.slice(index);
    const dvec3 step = stack.voxelStepMm();
    return crosshairMm - slice.depthMm(crosshairMm) / glm::dot(step, slice.normal()) * step;
}

dvec2 lineOf(const SliceStack& other, const SlicePlane& slice) {
    const dvec3 along = glm::cross(slice.normal(), other.across());
    const dvec2 line(glm::dot(along, slice.right), glm::dot(along, slice.down));
    return std::abs(line.x) > std::abs(line.y) ? line / line.x : line / line.y;
}

dvec3 nudged(const SliceStack& stack, const VolumeGeometry& geometry, dvec3 crosshairMm, ivec2 voxels) {
    const SlicePlane slice = stack.slice(0);
    const dvec3 moved = crosshairMm + voxels.x * sliceStepMm(geometry, slice.right) * slice.right +
                        voxels.y * sliceStepMm(geometry, slice.down) * slice.down;
    const dvec3 index = dvec3(glm::inverse(geometry.patientFromIndex) * dvec4(moved, 1));
    const dvec3 inside = glm::clamp(index, dvec3(0), dvec3(geometry.size - 1));
    return inside == index ? moved : dvec3(geometry.patientFromIndex * dvec4(inside, 1));
}

}  // namespace pdr::app
