#pragma once
/// Takes samples for Exposure Render's schedule on a GPU: one sample of every pixel per launch.

#include <utility>

#include "render/device/baseline/frame_sampler.h"
#include "render/device/gpu/gpu_scene.h"
#include "render/device/gpu/tracer.h"

namespace pdr {

/// Writes for each pixel its one sample, and whether it counts.
struct KeepSampleKernel {
    TraceTarget from;
    SampledPixel* frame;

    PDR_HD void operator()(std::int64_t index) const {
        PixelSums sums;
        const vec3 radiance = from.radiance[index];
        const bool counts = addSample(sums, radiance, 0);
        if (!counts)
            from.health->note(faultOf(radiance), from.grid.samples.first, std::uint32_t(index));
        frame[index] = {counts ? radiance : vec3(0), std::uint16_t(counts), std::uint16_t(from.seen[index])};
    }
};

template <Gpu G>
class GpuFrameSampler final : public FrameSampler {
  public:
    /// Keeps references to its arguments, which must outlive it.
    GpuFrameSampler(G& gpu, const GpuScene<G>& scene)
        : gpu_(gpu), scene_(scene), radiance_(gpu), paths_(gpu), seen_(gpu), health_(gpu, 1) {}

    void restart(const Tile& area) override {
        area_ = area;
        const std::size_t pixels = pixelCount(area);
        radiance_.resize(pixels);
        seen_.resize(pixels);
        seen_.clear();
        gpu_.launch(ForgetFaultsKernel{health_.data()}, 1, GpuStream::compute);
    }

    Result<void> sample(std::uint64_t number, SampledPixel* frame, std::stop_token) override {
        if (Result<void> scene = scene_.isThere(); !scene)
            return scene;
        const TraceTarget target{{area_, {number, 1}}, radiance_.data(), health_.data(), seen_.data(), area_.width};
        traceLaunchFor<G>(scene_.flat())(gpu_, scene_.flat(), target, paths_);
        gpu_.launch(KeepSampleKernel{target, frame}, target.grid.pixels(), GpuStream::compute);
        return takeStatus(gpu_);
    }

    Result<Health> takeHealth() override {
        GpuHealth counted;
        health_.copyTo(&counted);
        gpu_.awaitAll();
        gpu_.launch(ForgetFaultsKernel{health_.data()}, 1, GpuStream::compute);
        if (Result<void> done = takeStatus(gpu_); !done)
            return done.error();
        return toHealth(counted);
    }

    std::shared_ptr<const PreparedScene> scene() const override { return scene_.prepared(); }
    FlatScene sceneOnDevice() const override { return scene_.flat(); }

  private:
    G& gpu_;
    const GpuScene<G>& scene_;
    Tile area_;
    GpuArray<G, vec3> radiance_;
    PathListMemory<G> paths_;
    GpuArray<G, std::uint32_t> seen_;
    GpuArray<G, GpuHealth> health_;
};

}  // namespace pdr
