#include "render/volume/sheared.h"

#include <cmath>
#include <numbers>

namespace pdr {

double SliceDrift::degrees() const {
    return std::atan2(glm::length(sidewaysMm), gapMm) * 180 / std::numbers::pi;
}

SliceDrift sliceDrift(const VolumeGeometry& geometry) {
    constexpr double kRounding = 1e-5;
    const dmat3 steps(geometry.patientFromIndex);
    const dvec3 row = glm::normalize(steps[0]), column = glm::normalize(steps[1]);
    const dvec2 sideways(glm::dot(row, steps[2]), glm::dot(column, steps[2]));
    const double gap = std::abs(glm::dot(glm::normalize(glm::cross(row, column)), steps[2]));
    if (glm::length(sideways) <= kRounding * gap)
        return {dvec2(0), glm::length(steps[2])};
    return {sideways, gap};
}

dvec3 statedSpacingMm(const VolumeGeometry& geometry) {
    return {dvec2(geometry.spacingMm()), sliceDrift(geometry).gapMm};
}

double voxelMl(const VolumeGeometry& geometry) {
    return std::abs(glm::determinant(dmat3(geometry.patientFromIndex))) / 1000;
}

}  // namespace pdr
