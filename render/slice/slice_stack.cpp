#include "render/slice/slice_stack.h"

#include <algorithm>
#include <array>
#include <cmath>

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

/// Returns the number of whole pixels that lie before the first voxel's centre, and sets `pixels` to that of all.
int pixelsBefore(int voxels, double pixelsPerVoxel, int& pixels) {
    const int before = int(0.5 * pixelsPerVoxel);
    pixels = before + 1 + int((voxels - 0.5) * pixelsPerVoxel);
    return before;
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
    const dvec3 spacing = geometry.spacingMm();
    first_.right = right.unit;
    first_.down = glm::normalize(down.unit - glm::dot(down.unit, right.unit) * right.unit);
    first_.mmPerPixel = std::min(spacing[right.axis], spacing[down.axis]);
    dvec3 corner;
    for (const FollowedAxis& axis : {right, down, next})
        corner[axis.axis] = axis.sign > 0 ? 0 : geometry.size[axis.axis] - 1;
    const int before = pixelsBefore(geometry.size[right.axis], spacing[right.axis] / first_.mmPerPixel, first_.size.x);
    const int above = pixelsBefore(geometry.size[down.axis], spacing[down.axis] / first_.mmPerPixel, first_.size.y);
    first_.originMm = dvec3(geometry.patientFromIndex * dvec4(corner, 1));
    first_.originMm = first_.mmAt({-before, -above});

    stepMm_ = double(next.sign) * dvec3(geometry.patientFromIndex[next.axis]);
    across_ = glm::dot(stepMm_, first_.normal()) < 0 ? -first_.normal() : first_.normal();
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
