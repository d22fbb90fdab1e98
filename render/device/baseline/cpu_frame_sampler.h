#pragma once
/// Takes samples for Exposure Render's schedule on the CPU.

#include <vector>

#include "render/device/baseline/frame_sampler.h"
#include "render/device/cpu/cpu_tracer.h"
#include "render/device/emulated/host_gpu.h"

namespace pdr {

class CpuFrameSampler final : public FrameSampler {
  public:
    /// Keeps references to its arguments, which must outlive it. `scene` is where the device keeps its last uploaded
    /// scene.
    CpuFrameSampler(CpuTracer& tracer, HostGpu& gpu, const std::shared_ptr<const PreparedScene>& scene)
        : tracer_(tracer), gpu_(gpu), scene_(scene) {}

    void restart(const Tile& area) override;
    Result<void> sample(std::uint64_t number, SampledPixel* frame, std::stop_token stop) override;
    Result<Health> takeHealth() override { return std::exchange(health_, {}); }

    std::shared_ptr<const PreparedScene> scene() const override { return scene_; }
    FlatScene sceneOnDevice() const override { return scene_->flat; }

  private:
    CpuTracer& tracer_;
    HostGpu& gpu_;
    const std::shared_ptr<const PreparedScene>& scene_;
    Tile area_;
    std::vector<PixelSums> sums_;  ///< sums of the current frame; zero between two samples
    Health health_;
};

}  // namespace pdr
