#pragma once
/// The film of the CPU device.

#include <memory>

#include "render/device/cpu/cpu_tracer.h"
#include "render/device/host_accumulator.h"
#include "render/prepare/flatten.h"

namespace pdr {

class CpuAccumulator final : public HostAccumulator {
  public:
    /// Keeps references to `tracer` and `scene`, where the device keeps its last uploaded scene. Both must outlive it.
    CpuAccumulator(CpuTracer& tracer, const std::shared_ptr<const PreparedScene>& scene, const Tile& area,
                   std::uint64_t revision)
        : HostAccumulator(area, revision), tracer_(tracer), scene_(scene) {}

    /// A stop request waits for one piece of the image: any order may be whole.
    OrderSize orderSize() const override { return {.whole = 1}; }

    using Accumulator::accumulate;
    Result<void> accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) override;
    /// Takes all samples of one piece before it goes on to the next: those of a pixel pass the same voxels.
    Result<std::uint64_t> extend(std::uint64_t had, std::uint32_t n, std::stop_token stop,
                                 const Extended& told = {}) override;

  private:
    Result<std::uint64_t> begin(std::uint32_t n, const std::stop_token& stop);
    void take(const EvenTile& from, std::uint32_t n, const std::stop_token& end, const std::stop_token& breakOff);

    CpuTracer& tracer_;
    const std::shared_ptr<const PreparedScene>& scene_;
};

}  // namespace pdr
