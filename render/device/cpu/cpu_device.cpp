#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <thread>
#include <utility>

#include "render/device/cpu/cpu_film.h"
#include "render/device/cpu/cpu_frame_sampler.h"
#include "render/device/cpu/host_gpu.h"
#include "render/device/cpu/marched_tile.h"
#include "render/device/cpu/pixel_batch.h"
#include "render/device/cpu/projection_batch.h"
#include "render/device/device.h"
#include "render/device/gpu/kroes_film.h"

namespace pdr {

namespace {

/// Pixels along an edge of what one thread takes at a time. Larger where a pixel is one short ray: the last rays of a
/// task leave lanes empty.
constexpr int kScatteringTask = 16, kProjectionTask = 32;

using TileKernel = void (*)(PixelBatch& batch, const FlatScene& scene, const Tile& tile, SampleRange samples,
                            TileSums sums);

/// The one table from a feature mask to the code compiled for it.
template <std::size_t... Masks>
constexpr std::array<TileKernel, sizeof...(Masks)> tileKernels(std::index_sequence<Masks...>) {
    return {[](PixelBatch& batch, const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums) {
        batch.render<std::uint32_t(Masks)>(scene, tile, samples, sums);
    }...};
}
constexpr auto kTileKernels = tileKernels(std::make_index_sequence<kFeatureMasks>());

class CpuDevice final : public Device {
  public:
    explicit CpuDevice(int threads)
        : threads_(threads > 0 ? threads : int(std::thread::hardware_concurrency())),
          allowed_(tbb::global_control::max_allowed_parallelism,
                   std::max(threads_, tbb::this_task_arena::max_concurrency())),
          arena_(threads_),
          gpu_(0, threads_) {}

    DeviceInfo info() const override { return {"cpu", std::to_string(threads_) + " threads", true}; }

    Result<void> upload(std::shared_ptr<const PreparedScene> scene) override {
        scene_ = std::move(scene);
        return {};
    }

    Result<void> render(const Tile& tile, SampleRange samples, TileSums sums, std::stop_token stop) override {
        const FlatScene& flat = scene_->flat;
        const bool scattering = flat.optics.model == FlatModel::scattering;
        const TileKernel renderTile = kTileKernels[flat.features];
        const std::size_t task = scattering ? kScatteringTask : kProjectionTask;
        const tbb::blocked_range2d<int> pixels(0, tile.height, task, 0, tile.width, task);
        tbb::enumerable_thread_specific<Health> healths;
        const auto work = [&](const tbb::blocked_range2d<int>& piece) {
            if (stop.stop_requested())
                return;
            const int x = piece.cols().begin(), y = piece.rows().begin();
            const Tile part{tile.x + x, tile.y + y, int(piece.cols().size()), int(piece.rows().size())};
            const TileSums partSums{sums.pixels + std::ptrdiff_t(y) * sums.stride + x, sums.stride, &healths.local()};
            if (flat.marched)
                renderMarched(flat, part, samples, partSums);
            else if (scattering)
                renderTile(batches_.local(), flat, part, samples, partSums);
            else
                projections_.local().render(flat, part, samples, partSums);
        };
        arena_.execute([&] { tbb::parallel_for(pixels, work, tbb::simple_partitioner()); });
        if (sums.health != nullptr)
            for (const Health& health : healths)
                sums.health->add(health);
        return {};
    }

    Result<std::unique_ptr<LiveFilm>> film(ivec2 size, std::uint64_t revision, const Schedule& schedule) override {
        if (schedule.kind == Schedule::Kind::kroes)
            return KroesFilm<HostGpu>::make(gpu_, size, revision, schedule,
                                            std::make_unique<CpuFrameSampler>(*this, gpu_, scene_, size));
        return std::unique_ptr<LiveFilm>(std::make_unique<CpuFilm>(*this, size, revision));
    }

  private:
    int threads_;
    tbb::global_control allowed_;  ///< more threads than cores, when asked for
    tbb::task_arena arena_;
    HostGpu gpu_;  ///< for schedules that are written for GPUs
    tbb::enumerable_thread_specific<PixelBatch> batches_;
    tbb::enumerable_thread_specific<ProjectionBatch> projections_;
    std::shared_ptr<const PreparedScene> scene_;
};

}  // namespace

std::unique_ptr<Device> makeCpuDevice(int threads) {
    return std::make_unique<CpuDevice>(threads);
}

}  // namespace pdr
