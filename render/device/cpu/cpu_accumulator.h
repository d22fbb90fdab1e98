#pragma once
/// The film of the CPU: it lies on the host, and nothing goes on behind.

#include <deque>
#include <memory>

#include "render/device/accumulator.h"
#include "render/device/cpu/cpu_tracer.h"
#include "render/prepare/flatten.h"

namespace pdr {

class CpuAccumulator final : public Accumulator {
  public:
    /// `scene`: where its device keeps what was uploaded last. Both must outlive it.
    CpuAccumulator(CpuTracer& tracer, const std::shared_ptr<const PreparedScene>& scene, const Tile& area,
                   std::uint64_t revision)
        : tracer_(tracer), scene_(scene), film_(area, revision) {}

    using Accumulator::accumulate;
    using Accumulator::resolve;

    Tile area() const override { return film_.area(); }
    Result<void> accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) override;
    Result<void> resolve(const Display& display, std::stop_token stop) override;
    Result<Picture> readback() override;
    int maxInFlight() const override { return 1; }
    Result<std::shared_ptr<const Film>> film() override { return std::make_shared<const Film>(film_); }
    Result<void> look(const std::function<void(const Film&)>& use) override {
        use(film_);
        return {};
    }
    Result<void> resume(const Film& film) override;
    Result<void> restart(const Tile& area, std::uint64_t revision) override;

  private:
    CpuTracer& tracer_;
    const std::shared_ptr<const PreparedScene>& scene_;
    Film film_;
    Development development_;
    std::deque<Picture> shown_;
};

}  // namespace pdr
