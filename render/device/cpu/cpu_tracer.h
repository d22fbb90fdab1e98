#pragma once
/// Takes samples with the CPU's threads, into sums on the host. They work in the background where the thread that calls
/// does (base/background_thread.h).

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <memory>
#include <stop_token>

#include "render/device/cpu/guide_batch.h"
#include "render/device/cpu/pixel_batch.h"
#include "render/device/cpu/projection_batch.h"

namespace pdr {

class CpuTracer {
  public:
    /// Uses `threads` threads; 0 = one thread per core.
    explicit CpuTracer(int threads = 0);

    int threads() const { return threads_; }
    /// Adds `samples` of every pixel of `tile` to `sums`, in order. After a stop request it returns early and the sums
    /// are invalid.
    void trace(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums,
               const std::stop_token& stop = {});
    /// Renders a guide; see Device::guide().
    std::shared_ptr<const denoise::Guide> guide(const FlatScene& scene, const denoise::GuideRays& rays,
                                                const std::stop_token& stop);

  private:
    int threads_;
    tbb::global_control allowed_;  ///< allows more threads than cores, if requested
    tbb::task_arena arena_;
    tbb::enumerable_thread_specific<PixelBatch> batches_;
    tbb::enumerable_thread_specific<ProjectionBatch> projections_;
    tbb::enumerable_thread_specific<GuideBatch> guides_;
};

}  // namespace pdr
