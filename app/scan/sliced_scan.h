#pragma once
/// The scan that slices show: a volume, or what has arrived of one that is still being read.

#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "render/slice/arriving_slice.h"
#include "render/volume/arriving_volume.h"
#include "render/volume/value_unit.h"
#include "render/volume/volume.h"

namespace pdr::app {

class SlicedScan {
  public:
    /// No scan.
    SlicedScan() = default;
    SlicedScan(std::shared_ptr<const Volume> volume) : volume_(std::move(volume)) {}
    SlicedScan(std::shared_ptr<const ArrivingVolume> arriving)
        : arriving_(std::move(arriving)), arrived_(arriving_ ? arriving_->arrived() : 0) {}

    explicit operator bool() const { return volume_ || arriving_; }
    /// The complete volume; null while it arrives.
    const std::shared_ptr<const Volume>& volume() const { return volume_; }
    /// The volume that is being read; null once it is complete.
    const std::shared_ptr<const ArrivingVolume>& arriving() const { return arriving_; }

    /// Returns the grid. Needs a scan, as unit() does.
    const VolumeGeometry& geometry() const { return volume_ ? volume_->geometry() : arriving_->geometry(); }
    ValueUnit unit() const { return volume_ ? unitOf(*volume_) : arriving_->unit(); }

    /// Returns whether both are the same scan, with as many slices that have arrived.
    bool operator==(const SlicedScan&) const = default;

  private:
    std::shared_ptr<const Volume> volume_;
    std::shared_ptr<const ArrivingVolume> arriving_;
    int arrived_ = 0;  ///< slices that had arrived when this was made
};

/// Returns the slice of a scan on `plane`; what has not arrived is kNotArrived. `memory`: see reslice(). None: a stop
/// was requested, or the arriving volume has become a complete one.
std::optional<SliceImage> reslice(const SlicedScan& scan, const SlicePlane& plane, const std::stop_token& stop = {},
                                  std::vector<float> memory = {});

}  // namespace pdr::app
