#pragma once
/// A device whose films are filled by a device of its own and by the workers that share its work. The film is the same
/// to the last bit, no matter who renders which samples.

#include <memory>
#include <vector>

#include "render/device/device.h"
#include "render/device/host_accumulator.h"
#include "render/tiles/shared_work.h"

namespace pdr {

/// Makes such a device. `work` may serve one of each purpose at a time.
std::unique_ptr<Device> shareDevice(std::unique_ptr<Device> own, std::shared_ptr<SharedWork> work,
                                    Purpose purpose = Purpose::viewport);

class SharedAccumulator final : public HostAccumulator {
  public:
    /// `own`, `work` and `scene`, the number of the published scene, must outlive it.
    SharedAccumulator(Device& own, SharedWork& work, const std::uint64_t& scene, const Tile& area,
                      std::uint64_t revision)
        : HostAccumulator(area, revision), own_(own), work_(work), scene_(scene) {}

    using Accumulator::accumulate;
    OrderSize orderSize() const override;
    Result<void> accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) override;
    Result<std::uint64_t> extend(std::uint64_t had, std::uint32_t n, std::stop_token stop,
                                 const Extended& told) override;
    Contributors contributors() const override { return contributors_; }
    void credit(const Contributors& contributors) override {
        contributors_.insert(contributors.begin(), contributors.end());
    }
    Result<void> restart(const Tile& area, std::uint64_t revision) override;

  private:
    std::vector<TileGoal> goalsOf(const Tile& region, std::uint32_t n) const;
    /// Empties the film if results of an untrusted node are merged into it. Returns whether it did.
    bool discardUntrusted();
    /// Renders all goals on the own device and the workers. False: there are none, or they serve another scene.
    Result<bool> together(const std::vector<TileGoal>& goals, const std::stop_token& stop, const Extended& told);
    /// Renders all goals on the own device. A stop leaves a worthless film.
    Result<void> alone(const std::vector<TileGoal>& goals, const std::stop_token& stop);
    /// Renders all goals on the own device, lease by lease. A stop leaves whole tiles.
    Result<void> leaseByLease(const std::vector<TileGoal>& goals, const std::stop_token& stop, const Extended& told);

    Device& own_;
    SharedWork& work_;
    const std::uint64_t& scene_;
    Contributors contributors_;  ///< workers with merged results that were not audited as a whole
};

}  // namespace pdr
