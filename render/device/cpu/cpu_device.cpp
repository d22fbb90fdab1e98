#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <thread>

#include "render/device/device.h"
#include "render/kernel/dispatch.h"

namespace pdr {

namespace {

constexpr int kTask = 16;  ///< pixels along an edge of what one thread takes at a time

class CpuDevice final : public Device {
  public:
    explicit CpuDevice(int threads)
        : threads_(threads > 0 ? threads : int(std::thread::hardware_concurrency())), arena_(threads_) {}

    DeviceInfo info() const override { return {"cpu", std::to_string(threads_) + " threads"}; }

    Result<void> upload(std::shared_ptr<const PreparedScene> scene) override {
        scene_ = std::move(scene);
        return {};
    }

    Result<void> render(const Tile& tile, SampleRange samples, TileSums sums, std::stop_token stop) override {
        const FlatScene& flat = scene_->flat;
        const RowKernel renderRow = kRowKernels[flat.features];
        const tbb::blocked_range2d<int> pixels(0, tile.height, kTask, 0, tile.width, kTask);
        const auto work = [&](const tbb::blocked_range2d<int>& piece) {
            for (int y = piece.rows().begin(); y != piece.rows().end() && !stop.stop_requested(); ++y) {
                const int x = piece.cols().begin(), width = piece.cols().end() - x;
                renderRow(flat, tile.x + x, width, tile.y + y, samples,
                          sums.pixels + std::ptrdiff_t(y) * sums.stride + x);
            }
        };
        arena_.execute([&] { tbb::parallel_for(pixels, work, tbb::simple_partitioner()); });
        return {};
    }

  private:
    int threads_;
    tbb::task_arena arena_;
    std::shared_ptr<const PreparedScene> scene_;
};

}  // namespace

std::unique_ptr<Device> makeCpuDevice(int threads) {
    return std::make_unique<CpuDevice>(threads);
}

}  // namespace pdr
