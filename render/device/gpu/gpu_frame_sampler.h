#pragma once
/// Samples for the schedule of Exposure Render, taken by a GPU: one of every pixel in a launch.

#include <utility>

#include "render/device/gpu/frame_sampler.h"
#include "render/device/gpu/gpu_scene.h"
#include "render/device/gpu/tracer.h"

namespace pdr {

/// For each pixel: its one sample, and whether it counts.
struct KeepSampleProgram {
    TraceTarget from;
    SampledPixel* frame;

    PDR_HD void operator()(std::int64_t index) const {
        PixelSums sums;
        const vec3 radiance = from.radiance[index];
        const bool counts = addSample(sums, radiance);
        if (!counts)
            from.health->note(faultOf(radiance), from.grid.samples.first, std::uint32_t(index));
        frame[index] = {counts ? radiance : vec3(0), std::uint16_t(counts), std::uint16_t(from.seen[index])};
    }
};

template <Gpu G>
class GpuFrameSampler final : public FrameSampler {
  public:
    /// All must outlive it.
    GpuFrameSampler(G& gpu, const GpuScene<G>& scene, ivec2 size)
        : gpu_(gpu), scene_(scene), size_(size), radiance_(gpu, std::size_t(size.x) * size.y), seen_(gpu, std::size_t(size.x) * size.y), health_(gpu, 1) {
        seen_.clear();
        const GpuHealth perfect;
        health_.copyFrom(&perfect);
    }

    Result<void> sample(std::uint64_t number, SampledPixel* frame, std::stop_token) override {
        if (Result<void> scene = scene_.isThere(); !scene)
            return scene;
        const TraceTarget target{{{0, 0, size_.x, size_.y}, {number, 1}}, radiance_.data(), health_.data(), seen_.data()};
        traceLaunchFor<G>(scene_.flat())(gpu_, scene_.flat(), target);
        gpu_.launch(KeepSampleProgram{target, frame}, target.grid.pixels(), GpuStream::compute);
        return outcome(gpu_);
    }

    Result<Health> takeHealth() override {
        GpuHealth counted;
        health_.copyTo(&counted);
        gpu_.awaitAll();
        const GpuHealth perfect;
        health_.copyFrom(&perfect);
        if (Result<void> done = outcome(gpu_); !done)
            return done.error();
        return toHealth(counted);
    }

    std::shared_ptr<const PreparedScene> scene() const override { return scene_.prepared(); }
    FlatScene sceneOnDevice() const override { return scene_.flat(); }

  private:
    G& gpu_;
    const GpuScene<G>& scene_;
    ivec2 size_;
    GpuArray<G, vec3> radiance_;
    GpuArray<G, std::uint32_t> seen_;
    GpuArray<G, GpuHealth> health_;
};

}  // namespace pdr
