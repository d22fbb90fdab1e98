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

    using Accumulator::accumulate;
    Result<void> accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) override;

  private:
    CpuTracer& tracer_;
    const std::shared_ptr<const PreparedScene>& scene_;
};

}  // namespace pdr
