#include "render/device/cpu/cpu_tracer.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <thread>
#include <utility>

#include "render/base/background_thread.h"
#include "render/device/cpu/marched_tile.h"

namespace pdr {

namespace {

/// Returns the edge of the square of pixels that one of `threads` takes at a time. The last paths of a task leave lanes
/// empty, so a task has some thousand paths, but no thread goes without tasks. The number of samples does not matter
/// for projections: the sum along a ray is the same for all samples of a pixel.
int taskEdge(bool scattering, std::uint32_t samples, const Tile& tile, int threads) {
    constexpr int kPathsPerTask = 4096, kTasksPerThread = 4, kLeast = 16, kProjection = 32;
    const double enoughTasks = double(pixelCount(tile)) / (kTasksPerThread * threads);
    const double pixels = scattering ? std::min(enoughTasks, double(kPathsPerTask) / samples) : enoughTasks;
    int edge = scattering ? 4 * kLeast : kProjection;
    while (edge > kLeast && double(edge) * edge > pixels)
        edge /= 2;
    return edge;
}

using TileKernel = void (*)(PixelBatch& batch, const FlatScene& scene, const Tile& tile, SampleRange samples,
                            TileSums sums);

/// The only table from a feature mask to the code compiled for it.
template <std::size_t... Masks>
constexpr std::array<TileKernel, sizeof...(Masks)> tileKernels(std::index_sequence<Masks...>) {
    return {[](PixelBatch& batch, const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums) {
        batch.render<std::uint32_t(Masks)>(scene, tile, samples, sums);
    }...};
}
constexpr auto kTileKernels = tileKernels(std::make_index_sequence<kFeatureMasks>());

}  // namespace

CpuTracer::CpuTracer(int threads)
    : threads_(threads > 0 ? threads : int(std::thread::hardware_concurrency())),
      allowed_(tbb::global_control::max_allowed_parallelism,
               std::max(threads_, tbb::this_task_arena::max_concurrency())),
      arena_(threads_) {}

void CpuTracer::trace(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums,
                      const std::stop_token& stop) {
    const bool scattering = scene.optics.model == FlatModel::scattering;
    const TileKernel traceTile = kTileKernels[scene.features];
    const auto task = std::size_t(taskEdge(scattering, samples.count, tile, threads_));
    const tbb::blocked_range2d<int> pixels(0, tile.height, task, 0, tile.width, task);
    tbb::enumerable_thread_specific<Health> healths;
    const bool inBackground = worksInBackground();
    const auto work = [&](const tbb::blocked_range2d<int>& piece) {
        if (stop.stop_requested())
            return;
        if (inBackground)
            workInBackground();
        const int x = piece.cols().begin(), y = piece.rows().begin();
        const Tile part{tile.x + x, tile.y + y, int(piece.cols().size()), int(piece.rows().size())};
        const TileSums partSums{sums.pixels + std::ptrdiff_t(y) * sums.stride + x, sums.stride, &healths.local()};
        if (scene.marched)
            renderMarched(scene, part, samples, partSums);
        else if (scattering)
            traceTile(batches_.local(), scene, part, samples, partSums);
        else
            projections_.local().render(scene, part, samples, partSums);
    };
    arena_.execute([&] { tbb::parallel_for(pixels, work, tbb::simple_partitioner()); });
    if (sums.health != nullptr)
        for (const Health& health : healths)
            sums.health->add(health);
}

std::shared_ptr<const denoise::Guide> CpuTracer::guide(const FlatScene& scene, const denoise::GuideRays& rays,
                                                       const std::stop_token& stop) {
    constexpr int kRows = 8;
    if (!canBeGuided(scene))
        return nullptr;
    auto guide = std::make_shared<denoise::Guide>(denoise::guideOf(scene.camera.film, rays.finer));
    const ivec2 size = guide->depth.size();
    const bool inBackground = worksInBackground();
    const auto work = [&](int band) {
        const int y = band * kRows;
        if (inBackground)
            workInBackground();
        if (!stop.stop_requested())
            guides_.local().look(scene, {0, y, size.x, std::min(kRows, size.y - y)}, rays.place, *guide);
    };
    arena_.execute([&] { tbb::parallel_for(0, (size.y + kRows - 1) / kRows, work); });
    return stop.stop_requested() ? nullptr : guide;
}

}  // namespace pdr
