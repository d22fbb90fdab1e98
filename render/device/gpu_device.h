#pragma once
/// Implements Device for any Gpu.

#include <utility>

#include "render/device/baseline/gpu_frame_sampler.h"
#include "render/device/baseline/kroes_accumulator.h"
#include "render/device/device.h"
#include "render/device/gpu/gpu_accumulator.h"
#include "render/device/gpu/gpu_tile.h"

namespace pdr {

template <Gpu G>
class GpuDevice final : public Device {
  public:
    /// Makes the device; `arguments` go to the GPU's constructor.
    template <class... Arguments>
    explicit GpuDevice(DeviceInfo info, Arguments&&... arguments)
        : info_(std::move(info)), gpu_(std::forward<Arguments>(arguments)...), scene_(gpu_), tile_(gpu_, scene_) {}

    DeviceInfo info() const override {
        DeviceInfo now = info_;
        now.freeBytes = gpu_.memory().free;
        return now;
    }
    Result<void> upload(const Scene& scene) override {
        const std::shared_ptr<const PreparedScene> flattened = flattener_.flatten(scene);
        prepareKernels(gpu_, flattened->flat);
        return scene_.upload(flattened);
    }
    Result<void> unload() override {
        flattener_ = {};
        tile_.close();
        return scene_.close();
    }
    using Device::film;
    Result<std::unique_ptr<Accumulator>> film(const Tile& area, std::uint64_t revision,
                                              const Schedule& schedule) override;
    Result<void> trace(const Tile& tile, SampleRange samples, TileSums sums, const std::stop_token& stop) override {
        return tile_.trace(tile, samples, sums, stop);
    }

    G& gpu() { return gpu_; }

  private:
    DeviceInfo info_;
    G gpu_;
    Flattener flattener_;
    GpuScene<G> scene_;
    GpuTile<G> tile_;
};

template <Gpu G>
Result<std::unique_ptr<Accumulator>> GpuDevice<G>::film(const Tile& area, std::uint64_t revision,
                                                        const Schedule& schedule) {
    if (schedule.kind == Schedule::Kind::kroes)
        return KroesAccumulator<G>::make(gpu_, area, revision, schedule,
                                         std::make_unique<GpuFrameSampler<G>>(gpu_, scene_));
    auto film = std::make_unique<GpuAccumulator<G>>(gpu_, scene_);
    if (Result<void> room = film->restart(area, revision); !room)
        return room.error();
    return std::unique_ptr<Accumulator>(std::move(film));
}

}  // namespace pdr
