#include "render/volume/volume.h"

#include <algorithm>
#include <cassert>
#include <sstream>
#include <utility>

namespace pdr {

dvec3 VolumeGeometry::spacingMm() const {
    return {glm::length(dvec3(patientFromIndex[0])), glm::length(dvec3(patientFromIndex[1])),
            glm::length(dvec3(patientFromIndex[2]))};
}

std::size_t VolumeGeometry::voxelCount() const {
    return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
}

dvec3 VolumeGeometry::centreMm() const {
    return dvec3(patientFromIndex * dvec4((dvec3(size) - 1.0) * 0.5, 1.0));
}

double VolumeGeometry::radiusMm() const {
    return 0.5 * glm::length(dvec3(patientFromIndex * dvec4(dvec3(size), 0.0)));
}

VolumeGeometry VolumeGeometry::part(ivec3 first, ivec3 partSize) const {
    VolumeGeometry geometry{partSize, patientFromIndex};
    geometry.patientFromIndex[3] = patientFromIndex * dvec4(dvec3(first), 1.0);
    return geometry;
}

VolumeGeometry VolumeGeometry::aligned(ivec3 size, dvec3 spacingMm, dvec3 originMm) {
    dmat4 map(1.0);
    for (int axis = 0; axis < 3; ++axis)
        map[axis][axis] = spacingMm[axis];
    map[3] = dvec4(originMm, 1.0);
    return {size, map};
}

Result<void> checkSpacing(dvec3 spacingMm) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(spacingMm[axis] >= kLowestSpacingMm && spacingMm[axis] <= kHighestSpacingMm)) {
            std::ostringstream what;
            what << "voxels lie " << spacingMm[axis] << " mm apart, must be from " << kLowestSpacingMm << " to "
                 << kHighestSpacingMm;
            return Error{what.str(), "", "Check the unit: it is millimetres."};
        }
    return {};
}

Volume::Volume(VolumeGeometry geometry, Voxels voxels, std::vector<bool> padding, std::string remarks,
               std::string hidden)
    : geometry_(geometry),
      voxels_(std::move(voxels)),
      padding_(std::move(padding)),
      remarks_(std::move(remarks)),
      hidden_(std::move(hidden)) {
    assert(voxels_.size() == geometry_.voxelCount());
    assert(padding_.empty() || padding_.size() == voxels_.size());
    findRanges();
}

Volume Volume::clamped(std::int16_t lowest, std::int16_t highest) && {
    for (std::int16_t& hu : voxels_)
        hu = std::clamp(hu, lowest, highest);
    findRanges();
    return std::move(*this);
}

Volume Volume::withVoxels(Voxels voxels, std::string hidden) const {
    return Volume(geometry_, std::move(voxels), padding_, remarks_, std::move(hidden));
}

void Volume::findRanges() {
    const auto [low, high] = std::minmax_element(voxels_.begin(), voxels_.end());
    storedRange_ = {*low, *high};
    if (padding_.empty()) {
        lowestHu_ = *low;
        highestHu_ = *high;
        return;
    }
    paddingCount_ = std::size_t(std::count(padding_.begin(), padding_.end(), true));
    if (paddingCount_ == voxels_.size()) {
        lowestHu_ = highestHu_ = kAirHu;
        return;
    }
    lowestHu_ = INT16_MAX;
    highestHu_ = INT16_MIN;
    for (std::size_t i = 0; i < voxels_.size(); ++i) {
        if (padding_[i])
            continue;
        lowestHu_ = std::min(lowestHu_, voxels_[i]);
        highestHu_ = std::max(highestHu_, voxels_[i]);
    }
}

}  // namespace pdr
