#pragma once
/// Takes samples on a GPU for a film that lies elsewhere: the sums of a tile are uploaded, added to, and copied back.

#include <algorithm>
#include <cassert>
#include <stop_token>
#include <vector>

#include "render/device/gpu/gpu_scene.h"
#include "render/device/gpu/launch_size.h"
#include "render/device/gpu/tracer.h"

namespace pdr {

template <Gpu G>
class GpuTile {
  public:
    /// Keeps references to both, which must outlive it.
    GpuTile(G& gpu, const GpuScene<G>& scene) : gpu_(gpu), scene_(scene) {}

    /// Adds samples to sums on the host; see Device::trace(). After an error the sums are as before.
    Result<void> trace(const Tile& tile, SampleRange samples, TileSums sums, const std::stop_token& stop);
    /// Releases its memory.
    void close();

  private:
    void bring(const Tile& tile, const TileSums& sums);
    void takeBack(const Tile& tile, const TileSums& sums) const;

    G& gpu_;
    const GpuScene<G>& scene_;
    std::vector<PixelSums> onHost_;
    GpuArray<G, PixelSums> sums_{gpu_};
    GpuArray<G, vec3> radiance_{gpu_};
    GpuArray<G, std::uint32_t> seen_{gpu_};
    GpuArray<G, GpuHealth> health_{gpu_};
    PathListMemory<G> paths_{gpu_};
};

template <Gpu G>
Result<void> GpuTile<G>::trace(const Tile& tile, SampleRange samples, TileSums sums, const std::stop_token& stop) {
    if (Result<void> scene = scene_.isThere(); !scene)
        return scene;
    bring(tile, sums);
    const std::uint32_t together = LaunchSize(std::int64_t(onHost_.size())).most();
    for (std::uint32_t done = 0; done < samples.count && !stop.stop_requested();) {
        const SampleGrid grid{tile, {samples.first + done, std::min(together, samples.count - done)}};
        radiance_.resize(std::size_t(grid.pixels()) * grid.samples.count);
        traceAndAdd(gpu_, scene_.flat(), TraceTarget{grid, radiance_.data(), health_.data(), seen_.data(), tile.width},
                    paths_, sums_.data(), nullptr);
        done += grid.samples.count;
    }
    GpuHealth health;
    sums_.copyTo(onHost_.data());
    health_.copyTo(&health);
    gpu_.awaitAll();
    if (Result<void> done = takeStatus(gpu_); !done)
        return done;
    takeBack(tile, sums);
    if (sums.health != nullptr)
        sums.health->add(toHealth(health));
    return {};
}

template <Gpu G>
void GpuTile<G>::bring(const Tile& tile, const TileSums& sums) {
    const std::size_t pixels = pixelCount(tile);
    onHost_.resize(pixels);
    for (int y = 0; y < tile.height; ++y)
        std::copy_n(sums.pixels + std::ptrdiff_t(y) * sums.stride, tile.width,
                    onHost_.begin() + std::ptrdiff_t(y) * tile.width);
    sums_.resize(pixels);
    seen_.resize(pixels);
    seen_.clear();
    health_.resize(1);
    gpu_.launch(ForgetFaultsKernel{health_.data()}, 1, GpuStream::compute);
    sums_.copyFrom(onHost_.data());
}

template <Gpu G>
void GpuTile<G>::takeBack(const Tile& tile, const TileSums& sums) const {
    for (int y = 0; y < tile.height; ++y)
        std::copy_n(onHost_.begin() + std::ptrdiff_t(y) * tile.width, tile.width,
                    sums.pixels + std::ptrdiff_t(y) * sums.stride);
}

template <Gpu G>
void GpuTile<G>::close() {
    onHost_ = {};
    sums_.free();
    radiance_.free();
    seen_.free();
}

}  // namespace pdr
