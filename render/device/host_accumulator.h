#pragma once
/// A film on the host that works synchronously. Derived classes define how it gets its samples.

#include <deque>
#include <memory>
#include <utility>

#include "render/device/accumulator.h"
#include "render/film/display/tone_map.h"
#include "render/film/film.h"

namespace pdr {

class HostAccumulator : public Accumulator {
  public:
    HostAccumulator(const Tile& area, std::uint64_t revision) : film_(area, revision) {}

    using Accumulator::resolve;

    Tile area() const override { return film_.area(); }
    Result<void> resolve(const Display& display, std::stop_token stop) override;
    Result<Image> readback() override;
    int maxInFlight() const override { return 1; }
    Result<std::shared_ptr<const Film>> film() override { return std::make_shared<const Film>(film_); }
    Result<std::shared_ptr<const Film>> putAway() override { return std::make_shared<const Film>(std::move(film_)); }
    Result<void> look(const std::function<void(const Film&)>& use) override {
        use(film_);
        return {};
    }
    Result<void> resume(const Film& film) override;
    Result<void> restart(const Tile& area, std::uint64_t revision) override;

  protected:
    Film film_;

  private:
    Development development_;
    std::deque<Image> shown_;
};

}  // namespace pdr
