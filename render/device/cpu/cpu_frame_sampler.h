#pragma once
/// Samples for the schedule of Exposure Render from a device that renders into host memory.

#include <vector>

#include "render/device/cpu/host_gpu.h"
#include "render/device/device.h"
#include "render/device/gpu/frame_sampler.h"

namespace pdr {

class CpuFrameSampler final : public FrameSampler {
  public:
    /// `scene`: where the device keeps what was uploaded last. All must outlive it.
    CpuFrameSampler(Device& device, HostGpu& gpu, const std::shared_ptr<const PreparedScene>& scene, ivec2 size)
        : device_(device), gpu_(gpu), scene_(scene), size_(size), sums_(std::size_t(size.x) * std::size_t(size.y)) {}

    Result<void> sample(std::uint64_t number, SampledPixel* frame, std::stop_token stop) override;
    Result<Health> takeHealth() override { return std::exchange(health_, {}); }

    std::shared_ptr<const PreparedScene> scene() const override { return scene_; }
    FlatScene sceneOnDevice() const override { return scene_->flat; }

  private:
    Device& device_;
    HostGpu& gpu_;
    const std::shared_ptr<const PreparedScene>& scene_;
    ivec2 size_;
    std::vector<PixelSums> sums_;  ///< zero between two samples
    Health health_;
};

}  // namespace pdr
