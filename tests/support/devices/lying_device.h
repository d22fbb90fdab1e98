#pragma once
/// A CPU device in the role of a machine that falsifies samples.

#include <atomic>
#include <memory>
#include <utility>

#include "render/device/device_list.h"

namespace pdr::test {

/// What a LyingDevice does. A test may read it while the device renders.
struct Lies {
    int oneIn = 1;               ///< it falsifies a pixel of every so many-th tile
    std::atomic<int> tiles = 0;  ///< number of tiles that it has rendered

    int told() const { return tiles / oneIn; }
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
        if (++lies_->tiles % lies_->oneIn == 0)
            sums.pixels[0].sum.x += 1;
        return traced;
    }

  private:
    std::unique_ptr<Device> inner_;
    std::shared_ptr<Lies> lies_;
};

}  // namespace pdr::test
