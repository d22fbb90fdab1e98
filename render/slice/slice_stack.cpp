#include "render/slice/slice_stack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <tuple>
#include <utility>

#include "render/volume/sheared.h"

namespace pdr {
namespace {

/// An axis of the volume, followed in the direction that lies nearest to one of the patient.
struct FollowedAxis {
    int axis;    ///< axis of the volume: 0, 1, 2 for i, j, k
    int sign;    ///< -1: against the order of the voxels
    dvec3 unit;  ///< direction in the patient
};

/// Returns the axes of the volume that lead towards the patient's left, back and head: the assignment with the largest
/// sum of cosines.
std::array<FollowedAxis, 3> patientAxes(const VolumeGeometry& geometry) {
    std::array<dvec3, 3> units;
    for (int i = 0; i < 3; ++i)
        units[std::size_t(i)] = glm::normalize(dvec3(geometry.patientFromIndex[i]));
    std::array order{0, 1, 2}, best = order;
    double largest = -1;
    do {
        double sum = 0;
        for (int patient = 0; patient < 3; ++patient)
            sum += std::abs(units[std::size_t(order[std::size_t(patient)])][patient]);
        if (sum > largest) {
            largest = sum;
            best = order;
        }
    } while (std::ranges::next_permutation(order).found);
    std::array<FollowedAxis, 3> axes;
    for (int patient = 0; patient < 3; ++patient) {
        const int axis = best[std::size_t(patient)];
        const int sign = units[std::size_t(axis)][patient] < 0 ? -1 : 1;
        axes[std::size_t(patient)] = {axis, sign, double(sign) * units[std::size_t(axis)]};
    }
    return axes;
}

FollowedAxis reversed(const FollowedAxis& axis) {
    return {axis.axis, -axis.sign, -axis.unit};
}

/// Returns how far voxels reach along `unit` when they are followed along other axes than that of the image [mm]:
/// backwards (x) and forwards (y).
dvec2 reachMm(dvec3 unit, const VolumeGeometry& geometry, std::initializer_list<FollowedAxis> along) {
    dvec2 reach(0);
    for (const FollowedAxis& axis : along) {
        const double step = axis.sign * glm::dot(unit, dvec3(geometry.patientFromIndex[axis.axis]));
        const double low = -0.5 * step, high = (geometry.size[axis.axis] - 0.5) * step;
        reach += dvec2(std::max(-low, -high), std::max(low, high));
    }
    return reach;
}

/// The pixels along one direction of an image.
struct PixelLine {
    int before, count;  ///< whole pixels before the centre of the first voxel, and all
};

/// Returns the pixels along `unit` for the voxels along an axis, and for how far others lead along it, as reachMm()
/// returns it.
PixelLine pixelsFor(int voxels, double voxelMm, dvec2 othersMm, double mmPerPixel) {
    const double pixels = voxelMm / mmPerPixel;
    const int before = int(0.5 * pixels + othersMm.x / mmPerPixel);
    return {before, before + 1 + int((voxels - 0.5) * pixels + othersMm.y / mmPerPixel)};
}

/// Returns the directions of rows and columns of an image along two axes of the volume. Of two that are not at right
/// angles, the one along the table (k) stays, and the other one is turned.
std::pair<dvec3, dvec3> rowsAndColumns(const FollowedAxis& right, const FollowedAxis& down, bool isUpright) {
    const double off = glm::dot(down.unit, right.unit);
    if (!isUpright && down.axis == 2)
        return {glm::normalize(right.unit - off * down.unit), down.unit};
    return {right.unit, glm::normalize(down.unit - off * right.unit)};
}

}  // namespace

const char* planeName(AnatomicalPlane plane) {
    switch (plane) {
        case AnatomicalPlane::axial:
            return "axial";
        case AnatomicalPlane::coronal:
            return "coronal";
        case AnatomicalPlane::sagittal:
            return "sagittal";
    }
    return "";
}

SliceStack::SliceStack(const VolumeGeometry& geometry, AnatomicalPlane plane) {
    const auto [left, back, head] = patientAxes(geometry);
    const FollowedAxis right = plane == AnatomicalPlane::sagittal ? back : left;
    const FollowedAxis down = plane == AnatomicalPlane::axial ? back : reversed(head);
    const FollowedAxis next = plane == AnatomicalPlane::axial ? head : plane == AnatomicalPlane::coronal ? back : left;

    // Lay the pixels so that the voxel in the first corner is centred on one.
    const bool isUpright = sliceDrift(geometry).isUpright();
    const dvec3 spacing = geometry.spacingMm();
    std::tie(first_.right, first_.down) = rowsAndColumns(right, down, isUpright);
    first_.mmPerPixel = std::min(spacing[right.axis], spacing[down.axis]);
    voxelStepMm_ = double(next.sign) * dvec3(geometry.patientFromIndex[next.axis]);
    across_ = glm::dot(voxelStepMm_, first_.normal()) < 0 ? -first_.normal() : first_.normal();
    // Slices across those that were taken stay in place sideways, and hold what drifts past them.
    const bool staysInPlace = !isUpright && next.axis != 2;
    stepMm_ = staysInPlace ? glm::dot(voxelStepMm_, across_) * across_ : voxelStepMm_;
    const auto pixels = [&](const FollowedAxis& axis, dvec3 unit, const FollowedAxis& other) {
        const double mm = staysInPlace ? spacing[axis.axis] * glm::dot(axis.unit, unit) : spacing[axis.axis];
        const dvec2 others = staysInPlace ? reachMm(unit, geometry, {other, next}) : dvec2(0);
        return pixelsFor(geometry.size[axis.axis], mm, others, first_.mmPerPixel);
    };
    const PixelLine rows = pixels(right, first_.right, down), columns = pixels(down, first_.down, right);
    first_.size = {rows.count, columns.count};
    dvec3 corner;
    for (const FollowedAxis& axis : {right, down, next})
        corner[axis.axis] = axis.sign > 0 ? 0 : geometry.size[axis.axis] - 1;
    first_.originMm = dvec3(geometry.patientFromIndex * dvec4(corner, 1));
    first_.originMm = first_.mmAt({-rows.before, -columns.before});
    count_ = geometry.size[next.axis];
}

SlicePlane SliceStack::slice(int index) const {
    SlicePlane plane = first_;
    plane.originMm += double(index) * stepMm_;
    return plane;
}

SlicePlane SliceStack::at(double positionMm) const {
    const double perSlice = glm::dot(stepMm_, across_);
    SlicePlane plane = first_;
    plane.originMm += (positionMm - this->positionMm(first_.originMm)) / perSlice * stepMm_;
    return plane;
}

dvec2 SliceStack::rangeMm() const {
    const double half = 0.5 * glm::dot(stepMm_, across_);
    return {positionMm(first_.originMm) - half, positionMm(slice(count_ - 1).originMm) + half};
}

}  // namespace pdr
