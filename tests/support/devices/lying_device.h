#pragma once
/// A CPU device in the role of a machine that falsifies samples.

#include <atomic>
#include <memory>
#include <utility>

#include "tests/support/devices/forwarding_device.h"

namespace pdr::test {

/// What a LyingDevice does. A test may read it while the device renders.
struct Lies {
    int oneIn = 1;               ///< it falsifies a pixel of every so many-th tile
    std::atomic<int> tiles = 0;  ///< number of tiles that it has rendered

    int told() const { return tiles / oneIn; }
};

class LyingDevice final : public ForwardingDevice {
  public:
    LyingDevice(std::unique_ptr<Device> inner, std::shared_ptr<Lies> lies)
        : ForwardingDevice(std::move(inner)), lies_(std::move(lies)) {}

    Result<void> trace(const Tile& tile, SampleRange samples, TileSums sums, const std::stop_token& stop) override {
        Result<void> traced = ForwardingDevice::trace(tile, samples, sums, stop);
        if (++lies_->tiles % lies_->oneIn == 0)
            sums.pixels[0].sum.x += 1;
        return traced;
    }

  private:
    std::shared_ptr<Lies> lies_;
};

}  // namespace pdr::test
