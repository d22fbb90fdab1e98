#include "app/bench/accuracy_cost/metered_device.h"

#include <utility>

#include "render/base/processor_time.h"
#include "render/scene/scene.h"

namespace pdr::bench {
namespace {

class MeteredAccumulator final : public Accumulator {
  public:
    MeteredAccumulator(std::unique_ptr<Accumulator> film, bool isWhole, Told told, Meter& meter)
        : film_(std::move(film)), isWhole_(isWhole), told_(told), meter_(meter) {}

    Tile area() const override { return film_->area(); }
    Result<void> accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) override {
        const double start = processorSeconds();
        Result<void> done = film_->accumulate(region, n, std::move(stop));
        (isWhole_ ? meter_.samples : meter_.parts) += processorSeconds() - start;
        return done;
    }
    Result<void> resolve(const Display& display, std::stop_token stop) override {
        const Display raw = display.withDenoised(false);
        if (told_ == Told::status)
            return film_->resolve(raw, std::move(stop));
        return film_->look([&](const Film& film) {
            plain_ = {toneMap(film, raw), {.samplesPerPixel = film.samplesPerPixel()}};
        });
    }
    Result<Image> readback() override { return told_ == Told::status ? film_->readback() : std::move(plain_); }
    int maxInFlight() const override { return 1; }
    Result<std::shared_ptr<const Film>> film() override { return film_->film(); }
    Result<void> look(const std::function<void(const Film&)>& use) override { return film_->look(use); }
    Result<void> resume(const Film& film) override { return film_->resume(film); }
    Result<void> restart(const Tile& area, std::uint64_t revision) override { return film_->restart(area, revision); }

  private:
    std::unique_ptr<Accumulator> film_;
    bool isWhole_;
    Told told_;
    Meter& meter_;
    Image plain_;
};

class MeteredDevice final : public Device {
  public:
    MeteredDevice(std::unique_ptr<Device> device, Told told, Meter& meter)
        : device_(std::move(device)), told_(told), meter_(meter) {}

    DeviceInfo info() const override { return device_->info(); }
    Result<void> upload(const Scene& scene) override {
        size_ = scene.film;
        const double start = processorSeconds();
        Result<void> done = device_->upload(scene);
        meter_.parts += processorSeconds() - start;
        return done;
    }
    Result<void> unload() override { return device_->unload(); }
    Result<std::unique_ptr<Accumulator>> film(const Tile& area, std::uint64_t revision,
                                              const Schedule& schedule) override {
        auto film = device_->film(area, revision, schedule);
        if (!film)
            return film;
        const bool isWhole = area == wholeImage(size_);
        return std::unique_ptr<Accumulator>(
            std::make_unique<MeteredAccumulator>(*std::move(film), isWhole, told_, meter_));
    }

  private:
    std::unique_ptr<Device> device_;
    Told told_;
    Meter& meter_;
    ivec2 size_{0};
};

}  // namespace

std::unique_ptr<Device> meteredDevice(std::unique_ptr<Device> device, Told told, Meter& meter) {
    return std::make_unique<MeteredDevice>(std::move(device), told, meter);
}

}  // namespace pdr::bench
