#pragma once
/// A device that passes all calls on to another one. Devices that do one thing otherwise derive from it.

#include <memory>
#include <utility>

#include "render/device/device.h"

namespace pdr::test {

class ForwardingDevice : public Device {
  public:
    explicit ForwardingDevice(std::unique_ptr<Device> inner) : inner_(std::move(inner)) {}

    using Device::film;

    DeviceInfo info() const override { return inner_->info(); }
    Result<void> upload(const Scene& scene) override { return inner_->upload(scene); }
    Result<void> unload() override { return inner_->unload(); }
    Result<std::unique_ptr<Accumulator>> film(const Tile& area, std::uint64_t revision,
                                              const Schedule& schedule) override {
        return inner_->film(area, revision, schedule);
    }
    Result<void> trace(const Tile& tile, SampleRange samples, TileSums sums, const std::stop_token& stop) override {
        return inner_->trace(tile, samples, sums, stop);
    }
    std::shared_ptr<const denoise::Guide> guide(const denoise::GuideRays& rays, const std::stop_token& stop) override {
        return inner_->guide(rays, stop);
    }

  private:
    std::unique_ptr<Device> inner_;
};

}  // namespace pdr::test
