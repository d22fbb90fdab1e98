#pragma once
/// A volume while its slices are read: its voxels lie where they will stay, and the slices that have arrived can be
/// looked at meanwhile. Thread-safe.

#include <atomic>
#include <functional>
#include <shared_mutex>
#include <span>
#include <vector>

#include "render/volume/value_unit.h"
#include "render/volume/volume.h"

namespace pdr {

/// Slices of a volume that lie on each other and have arrived. It is a grid of its own.
struct ArrivedSlices {
    int first = 0;                           ///< number of the lowest slice in the volume
    VolumeGeometry geometry;                 ///< grid of these slices alone
    std::span<const std::int16_t> voxels{};  ///< x fastest, then y, then z
};

class ArrivingVolume {
  public:
    /// Takes the memory of the voxels; no slice has arrived yet. Throws std::bad_alloc.
    explicit ArrivingVolume(VolumeGeometry geometry, ValueUnit unit = {});

    const VolumeGeometry& geometry() const { return geometry_; }
    const ValueUnit& unit() const { return unit_; }

    /// Returns the voxels of slice `k`, to be written by one thread until it calls arrive(k). Not after take().
    std::span<std::int16_t> slice(int k);
    /// Reports that slice `k` is complete and stays as it is. Once for each slice.
    void arrive(int k);
    /// Returns the number of slices that have arrived.
    int arrived() const { return arrived_; }

    /// Takes the voxels out, once nobody looks at them: from then on they may change, and there is nothing to look at.
    /// A second call returns none.
    Voxels take();

    /// Calls look(parts) with the slices that have arrived, in as few parts as possible, ascending. They must not be
    /// used after that. Returns false, without a call, if the voxels were taken.
    bool look(const std::function<void(std::span<const ArrivedSlices>)>& look) const;

  private:
    std::vector<ArrivedSlices> parts() const;

    const VolumeGeometry geometry_;
    const ValueUnit unit_;
    mutable std::shared_mutex looking_;  ///< shared by those who look; held alone while the voxels are taken
    bool taken_ = false;                 ///< guarded by looking_
    Voxels voxels_;
    std::vector<std::atomic<bool>> complete_;  ///< set after the last voxel of a slice is written
    std::atomic<int> arrived_ = 0;
};

}  // namespace pdr
