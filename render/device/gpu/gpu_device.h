#pragma once
/// A GPU as a Device.

#include <utility>

#include "render/device/device.h"
#include "render/device/gpu/gpu_film.h"
#include "render/device/gpu/gpu_frame_sampler.h"
#include "render/device/gpu/kroes_film.h"

namespace pdr {

template <Gpu G>
class GpuDevice final : public Device {
  public:
    /// `arguments`: of the GPU's constructor.
    template <class... Arguments>
    explicit GpuDevice(DeviceInfo info, Arguments&&... arguments)
        : info_(std::move(info)), gpu_(std::forward<Arguments>(arguments)...), scene_(gpu_) {}

    DeviceInfo info() const override {
        DeviceInfo now = info_;
        now.freeBytes = gpu_.memory().free;
        return now;
    }
    Result<void> upload(std::shared_ptr<const PreparedScene> scene) override { return scene_.upload(std::move(scene)); }
    Result<void> render(const Tile& tile, SampleRange samples, TileSums sums, std::stop_token stop) override;
    Result<std::unique_ptr<LiveFilm>> film(ivec2 size, std::uint64_t revision, const Schedule& schedule) override;

    G& gpu() { return gpu_; }

  private:
    DeviceInfo info_;
    G gpu_;
    GpuScene<G> scene_;
};

/// In device memory and back: for those who want the sums themselves.
template <Gpu G>
Result<void> GpuDevice<G>::render(const Tile& tile, SampleRange samples, TileSums sums, std::stop_token stop) {
    if (Result<void> scene = scene_.isThere(); !scene)
        return scene;
    const SampleGrid grid{tile, samples};
    if (grid.pixels() == 0 || samples.count == 0)
        return {};
    GpuArray<G, PixelSums> pixels(gpu_, std::size_t(grid.pixels()));
    GpuArray<G, GpuHealth> health(gpu_, 1);
    GpuArray<G, vec3> radiance(gpu_);
    GpuArray<G, std::uint32_t> seen(gpu_, std::size_t(grid.pixels()));
    seen.clear();
    std::vector<PixelSums> rows(std::size_t(grid.pixels()));
    const auto eachRow = [&](auto&& visit) {
        for (int y = 0; y < tile.height; ++y)
            visit(sums.pixels + std::ptrdiff_t(y) * sums.stride, rows.data() + std::ptrdiff_t(y) * tile.width);
    };
    eachRow([&](const PixelSums* theirs, PixelSums* ours) { std::copy_n(theirs, tile.width, ours); });
    GpuHealth counted;
    pixels.copyFrom(rows.data());
    health.copyFrom(&counted);
    const std::uint32_t most = LaunchSize(grid.pixels()).most();
    for (std::uint32_t done = 0; done < samples.count && !stop.stop_requested();) {
        const std::uint32_t count = std::min(most, samples.count - done);
        radiance.resize(std::size_t(grid.pixels()) * count);
        const TraceTarget target{{tile, {samples.first + done, count}}, radiance.data(), health.data(),
                                 seen.data()};
        traceAndAdd<G>(gpu_, scene_.flat(), target, pixels.data(), nullptr);
        gpu_.awaitAll();
        done += count;
    }
    pixels.copyTo(rows.data());
    health.copyTo(&counted);
    gpu_.awaitAll();
    if (Result<void> all = outcome(gpu_); !all)
        return all;
    eachRow([&](PixelSums* theirs, const PixelSums* ours) { std::copy_n(ours, tile.width, theirs); });
    if (sums.health != nullptr)
        sums.health->add(toHealth(counted));
    return {};
}

template <Gpu G>
Result<std::unique_ptr<LiveFilm>> GpuDevice<G>::film(ivec2 size, std::uint64_t revision, const Schedule& schedule) {
    if (schedule.kind == Schedule::Kind::kroes)
        return KroesFilm<G>::make(gpu_, size, revision, schedule,
                                  std::make_unique<GpuFrameSampler<G>>(gpu_, scene_, size));
    auto film = std::make_unique<GpuFilm<G>>(gpu_, scene_, size, revision);
    if (Result<void> room = outcome(gpu_); !room)
        return room.error();
    return std::unique_ptr<LiveFilm>(std::move(film));
}

}  // namespace pdr
