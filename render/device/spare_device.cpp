#include "render/device/spare_device.h"

#include <optional>
#include <utility>

#include "render/scene/scene.h"

namespace pdr {
namespace {

class SpareDevice final : public Device {
  public:
    SpareDevice(std::unique_ptr<Device> first, Spare spare, WhySpare told)
        : device_(std::move(first)), spare_(std::move(spare)), told_(std::move(told)) {}

    using Device::film;

    DeviceInfo info() const override { return device_->info(); }
    Result<void> upload(const Scene& scene) override {
        scene_ = scene;
        Result<void> uploaded = device_->upload(scene);
        if (!uploaded && takeOver(uploaded.error()))
            return {};
        return uploaded;
    }
    Result<void> unload() override {
        scene_.reset();
        const Result<void> unloaded = device_->unload();
        return unloaded || takeOver(unloaded.error()) ? Result<void>() : unloaded;
    }
    Result<std::unique_ptr<Accumulator>> film(const Tile& area, std::uint64_t revision,
                                              const Schedule& schedule) override;
    Result<void> trace(const Tile& tile, SampleRange samples, TileSums sums, const std::stop_token& stop) override;
    std::shared_ptr<const denoise::Guide> guide(const denoise::GuideRays& rays, const std::stop_token& stop) override {
        return device_->guide(rays, stop);
    }

    /// Returns whether the spare device has the scene now. False: it cannot, or need not, do what failed.
    bool takeOver(const Error& error);
    Device& device() { return *device_; }

  private:
    std::unique_ptr<Device> failed_;  ///< kept, since it must outlive its films
    std::unique_ptr<Device> device_;
    Spare spare_;
    WhySpare told_;
    std::optional<Scene> scene_;
};

class SpareFilm final : public Accumulator {
  public:
    SpareFilm(SpareDevice& device, std::unique_ptr<Accumulator> film, std::uint64_t revision, const Schedule& schedule)
        : device_(device), film_(std::move(film)), revision_(revision), schedule_(schedule) {}

    using Accumulator::accumulate;
    using Accumulator::resolve;

    OrderSize orderSize() const override { return film_->orderSize(); }
    Tile area() const override { return film_->area(); }
    Result<void> accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) override {
        Result<void> done = film_->accumulate(region, n, stop);
        if (!done && !hasSamples_ && beginAnew(done.error(), area()))
            done = film_->accumulate(region, n, std::move(stop));
        hasSamples_ = hasSamples_ || done;
        return done;
    }
    Result<std::uint64_t> extend(std::uint64_t had, std::uint32_t n, std::stop_token stop,
                                 const Extended& told) override {
        Result<std::uint64_t> there = film_->extend(had, n, stop, told);
        if (!there && beginAnew(there.error(), area()))
            there = had > 0 ? Result<std::uint64_t>(0) : film_->extend(0, n, std::move(stop), told);
        hasSamples_ = there && *there > 0;
        return there;
    }
    Result<void> resolve(const Display& display, std::stop_token stop) override {
        return film_->resolve(display, std::move(stop));
    }
    Result<Image> readback() override { return film_->readback(); }
    int maxInFlight() const override { return film_->maxInFlight(); }
    Result<std::shared_ptr<const Film>> film() override { return film_->film(); }
    Result<std::shared_ptr<const Film>> putAway() override { return film_->putAway(); }
    Result<void> look(const std::function<void(const Film&)>& use) override { return film_->look(use); }
    Result<void> resume(const Film& film) override { return film_->resume(film); }
    Result<void> restart(const Tile& area, std::uint64_t revision) override {
        hasSamples_ = false;
        revision_ = revision;
        Result<void> begun = film_->restart(area, revision);
        if (!begun && beginAnew(begun.error(), area))
            return {};
        return begun;
    }

  private:
    /// Returns whether there is now an empty film on the spare device.
    bool beginAnew(const Error& error, const Tile& area) {
        if (!device_.takeOver(error))
            return false;
        auto film = device_.device().film(area, revision_, schedule_);
        if (!film)
            return false;
        film_ = *std::move(film);
        return true;
    }

    SpareDevice& device_;
    std::unique_ptr<Accumulator> film_;
    std::uint64_t revision_;
    Schedule schedule_;
    bool hasSamples_ = false;
};

bool SpareDevice::takeOver(const Error& error) {
    if (error.kind == ErrorKind::refused || error.kind == ErrorKind::cancelled)
        return false;
    if (failed_)
        return false;
    Result<std::unique_ptr<Device>> spare = spare_();
    if (!spare || (scene_ && !(*spare)->upload(*scene_)))
        return false;
    failed_ = std::exchange(device_, *std::move(spare));
    told_(error);
    return true;
}

Result<std::unique_ptr<Accumulator>> SpareDevice::film(const Tile& area, std::uint64_t revision,
                                                       const Schedule& schedule) {
    Result<std::unique_ptr<Accumulator>> film = device_->film(area, revision, schedule);
    if (!film && takeOver(film.error()))
        return device_->film(area, revision, schedule);
    if (!film || failed_)
        return film;
    return std::unique_ptr<Accumulator>(std::make_unique<SpareFilm>(*this, *std::move(film), revision, schedule));
}

/// Passes the same sums on to the other device: a GPU adds to them when all samples have succeeded (gpu/gpu_tile.h).
Result<void> SpareDevice::trace(const Tile& tile, SampleRange samples, TileSums sums, const std::stop_token& stop) {
    Result<void> traced = device_->trace(tile, samples, sums, stop);
    if (!traced && takeOver(traced.error()))
        return device_->trace(tile, samples, sums, stop);
    return traced;
}

}  // namespace

std::unique_ptr<Device> withSpare(std::unique_ptr<Device> first, Spare spare, WhySpare told) {
    return std::make_unique<SpareDevice>(std::move(first), std::move(spare), std::move(told));
}

}  // namespace pdr
