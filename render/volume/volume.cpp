#include "render/volume/volume.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cassert>
#include <sstream>
#include <utility>

namespace pdr {
namespace {

ValueRanges united(ValueRanges a, const ValueRanges& b) {
    a.include(b);
    return a;
}

/// Returns the range of some voxels. Two numbers of their own become vector instructions.
HuRange rangeOf(std::span<const std::int16_t> voxels) {
    std::int16_t lowest = INT16_MAX, highest = INT16_MIN;
    for (const std::int16_t hu : voxels) {
        lowest = std::min(lowest, hu);
        highest = std::max(highest, hu);
    }
    return {lowest, highest};
}

/// Returns the ranges of the voxels [begin, end). `padding` is empty or has a flag for each voxel.
ValueRanges rangesOf(const Voxels& voxels, const std::vector<bool>& padding, std::size_t begin, std::size_t end) {
    ValueRanges ranges;
    ranges.stored = rangeOf(std::span(voxels).subspan(begin, end - begin));
    if (padding.empty())
        ranges.measured = ranges.stored;
    else
        for (std::size_t i = begin; i < end; ++i) {
            const bool none = padding[i];
            ranges.measured.include({none ? std::int16_t(INT16_MAX) : voxels[i],  //
                                     none ? std::int16_t(INT16_MIN) : voxels[i]});
            ranges.padding += none;
        }
    return ranges;
}

}  // namespace

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
    // The diagonals of an upright box are equal, and rounding must not choose among them.
    constexpr double kLonger = 1 + 1e-9;
    const auto diagonal = [this](dvec3 signs) {
        return glm::length(dvec3(patientFromIndex * dvec4(signs * dvec3(size), 0.0)));
    };
    double longest = diagonal({1, 1, 1});
    for (const dvec3 signs : {dvec3(-1, 1, 1), dvec3(1, -1, 1), dvec3(1, 1, -1)})
        if (const double other = diagonal(signs); other > kLonger * longest)
            longest = other;
    return 0.5 * longest;
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
            return Error{phrase("voxels lie %1 mm apart, must be from %2 to %3", numberOf(spacingMm[axis]),
                                numberOf(kLowestSpacingMm), numberOf(kHighestSpacingMm)),
                         "", phrase("Check the unit: it is millimetres.")};
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

Volume::Volume(VolumeGeometry geometry, Voxels voxels, std::vector<bool> padding, std::string remarks,
               const ValueRanges& ranges)
    : geometry_(geometry), voxels_(std::move(voxels)), padding_(std::move(padding)), remarks_(std::move(remarks)) {
    assert(voxels_.size() == geometry_.voxelCount());
    assert(padding_.empty() || padding_.size() == voxels_.size());
    takeRanges(ranges);
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

Volume Volume::remarked(const std::string& remark) && {
    remarks_ += (remarks_.empty() ? "" : ", ") + remark;
    return std::move(*this);
}

Volume Volume::changed(const std::function<void(std::span<std::int16_t>)>& change, std::string hidden) && {
    change(voxels_);
    hidden_ = std::move(hidden);
    findRanges();
    return std::move(*this);
}

void Volume::findRanges() {
    constexpr std::size_t kTogether = 1 << 18;  // voxels
    takeRanges(tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, voxels_.size(), kTogether), ValueRanges(),
        [&](const tbb::blocked_range<std::size_t>& part, const ValueRanges& before) {
            return united(before, rangesOf(voxels_, padding_, part.begin(), part.end()));
        },
        united));
}

void Volume::takeRanges(const ValueRanges& ranges) {
    storedRange_ = ranges.stored;
    paddingCount_ = ranges.padding;
    lowestHu_ = ranges.measured.empty() ? kAirHu : ranges.measured.lowest;
    highestHu_ = ranges.measured.empty() ? kAirHu : ranges.measured.highest;
}

}  // namespace pdr
