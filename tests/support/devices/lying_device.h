#pragma once
/// A CPU device in the role of a machine that falsifies samples.

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

#include "render/device/device_list.h"

namespace pdr::test {

/// What a LyingDevice does. A test may read it while the device renders.
struct Lies {
    /// Number of samples that it renders as they are, before it falsifies a pixel of each tile.
    std::uint64_t honest = 0;
    std::atomic<std::uint64_t> samples = 0;  ///< number of samples that it has rendered
    std::atomic<int> told = 0;               ///< number of tiles that it has falsified
};

class LyingDevice final : public Device {
  public:
    LyingDevice(std::unique_ptr<Device> inner, std::shared_ptr<Lies> lies)
        : inner_(std::move(inner)), lies_(std::move(lies)) {}

    using Device::film;

    DeviceInfo info() const override { return inner_->info(); }
    Result<void> upload(const Scene& scene) override { return inner_->upload(scene); }
    Result<void> unload() override { return inner_->unload(); }
    Result<std::unique_ptr<Accumulator>> film(const Tile& area, std::uint64_t revision,
                                              const Schedule& schedule) override {
        return inner_->film(area, revision, schedule);
    }
    Result<void> trace(const Tile& tile, SampleRange samples, TileSums sums, const std::stop_token& stop) override {
        Result<void> traced = inner_->trace(tile, samples, sums, stop);
        lies_->samples += std::uint64_t(tile.width) * std::uint64_t(tile.height) * samples.count;
        if (lies_->samples <= lies_->honest)
            return traced;
        sums.pixels[0].sum.x += 1;
        ++lies_->told;
        return traced;
    }

  private:
    std::unique_ptr<Device> inner_;
    std::shared_ptr<Lies> lies_;
};

}  // namespace pdr::test
