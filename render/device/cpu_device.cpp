#include <utility>

#include "render/device/baseline/cpu_frame_sampler.h"
#include "render/device/baseline/kroes_accumulator.h"
#include "render/device/cpu/cpu_accumulator.h"
#include "render/device/device.h"
#include "render/device/emulated/host_gpu.h"
#include "render/scene/scene.h"

namespace pdr {

namespace {

class CpuDevice final : public Device {
  public:
    explicit CpuDevice(int threads) : tracer_(threads), gpu_(0, tracer_.threads()) {}

    using Device::film;

    DeviceInfo info() const override {
        const int threads = tracer_.threads();
        return {"cpu", std::to_string(threads) + (threads == 1 ? " thread" : " threads"), true};
    }

    Result<void> upload(const Scene& scene) override {
        scene_ = flattener_.prepare(scene);
        return {};
    }
    Result<void> unload() override {
        scene_ = nullptr;
        flattener_ = {};
        return {};
    }

    Result<void> trace(const Tile& tile, SampleRange samples, TileSums sums, const std::stop_token& stop) override {
        tracer_.trace(scene_->flat, tile, samples, sums, stop);
        return {};
    }

    std::shared_ptr<const denoise::Guide> guide(const denoise::GuideRays& rays, const std::stop_token& stop) override {
        return tracer_.guide(scene_->flat, rays, stop);
    }

    Result<std::unique_ptr<Accumulator>> film(const Tile& area, std::uint64_t revision,
                                              const Schedule& schedule) override {
        if (schedule.kind == Schedule::Kind::kroes)
            return KroesAccumulator<HostGpu>::make(gpu_, area, revision, schedule,
                                                   std::make_unique<CpuFrameSampler>(tracer_, gpu_, scene_));
        return std::unique_ptr<Accumulator>(std::make_unique<CpuAccumulator>(tracer_, scene_, area, revision));
    }

  private:
    CpuTracer tracer_;
    HostGpu gpu_;  ///< for schedules that are written for GPUs
    Flattener flattener_;
    std::shared_ptr<const PreparedScene> scene_;
};

}  // namespace

std::unique_ptr<Device> makeCpuDevice(int threads) {
    return std::make_unique<CpuDevice>(threads);
}

}  // namespace pdr
