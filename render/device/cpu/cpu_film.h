#pragma once
/// The film of the CPU: it lies on the host, and nothing goes on behind.

#include <deque>

#include "render/device/device.h"

namespace pdr {

class CpuFilm final : public LiveFilm {
  public:
    /// `device` must outlive it.
    CpuFilm(Device& device, ivec2 size, std::uint64_t revision) : device_(device), film_(size, revision) {}

    Result<void> iterate(std::uint32_t n, std::stop_token stop) override;
    Result<void> show(const Display& display) override;
    Result<Picture> take() override;
    int ahead() const override { return 1; }
    Result<std::shared_ptr<const Film>> film() override { return std::make_shared<const Film>(film_); }
    Result<void> resume(const Film& film) override;

  private:
    Device& device_;
    Film film_;
    std::deque<Picture> shown_;
};

}  // namespace pdr
