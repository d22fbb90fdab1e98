#include "render/volume/arriving_volume.h"

#include <mutex>
#include <utility>

namespace pdr {
namespace {

std::size_t sliceVoxels(const VolumeGeometry& geometry) {
    return std::size_t(geometry.size.x) * std::size_t(geometry.size.y);
}

}  // namespace

ArrivingVolume::ArrivingVolume(VolumeGeometry geometry, ValueUnit unit)
    : geometry_(geometry),
      unit_(std::move(unit)),
      voxels_(geometry.voxelCount()),
      complete_(std::size_t(geometry.size.z)) {}

std::span<std::int16_t> ArrivingVolume::slice(int k) {
    const std::size_t count = sliceVoxels(geometry_);
    return std::span(voxels_).subspan(std::size_t(k) * count, count);
}

void ArrivingVolume::arrive(int k) {
    complete_[std::size_t(k)].store(true, std::memory_order_release);
    ++arrived_;
}

Voxels ArrivingVolume::take() {
    const std::unique_lock alone(looking_);
    taken_ = true;
    return std::exchange(voxels_, {});
}

bool ArrivingVolume::look(const std::function<void(std::span<const ArrivedSlices>)>& look) const {
    const std::shared_lock shared(looking_);
    if (taken_)
        return false;
    look(parts());
    return true;
}

std::vector<ArrivedSlices> ArrivingVolume::parts() const {
    const std::size_t count = sliceVoxels(geometry_);
    const auto isComplete = [this](int k) { return complete_[std::size_t(k)].load(std::memory_order_acquire); };
    std::vector<ArrivedSlices> parts;
    for (int k = 0; k < geometry_.size.z; ++k) {
        const int first = k;
        while (k < geometry_.size.z && isComplete(k))
            ++k;
        if (k == first)
            continue;
        const ivec3 size(geometry_.size.x, geometry_.size.y, k - first);
        parts.push_back({first, geometry_.part({0, 0, first}, size),
                         std::span(voxels_).subspan(std::size_t(first) * count, std::size_t(size.z) * count)});
    }
    return parts;
}

}  // namespace pdr
