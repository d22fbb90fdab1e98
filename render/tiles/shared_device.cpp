#include "render/tiles/shared_device.h"

#include <limits>
#include <utility>

#include "render/scene/scene.h"
#include "render/tiles/own_part.h"
#include "render/tiles/trace_lease.h"

namespace pdr {
namespace {

class SharedDevice final : public Device {
  public:
    SharedDevice(std::unique_ptr<Device> own, std::shared_ptr<SharedWork> work, Purpose purpose)
        : own_(std::move(own)), work_(std::move(work)), purpose_(purpose) {}
    /// Withdraws this device's scene, but not one that another device has published since: both devices exist while a
    /// film moves to another device.
    ~SharedDevice() override { work_->withdraw(scene_); }

    using Device::film;

    DeviceInfo info() const override { return own_->info(); }

    Result<void> upload(const Scene& scene) override {
        if (Result<void> uploaded = own_->upload(scene); !uploaded)
            return uploaded;
        isShared_ = scene.filtering == Filtering::exact;  // results of texture units differ in their bits
        scene_ = work_->publish(purpose_, isShared_ ? std::make_shared<const Scene>(scene) : nullptr);
        return {};
    }
    Result<void> unload() override {
        work_->withdraw(scene_);
        return own_->unload();
    }
    Result<std::unique_ptr<Accumulator>> film(const Tile& area, std::uint64_t revision,
                                              const Schedule& schedule) override {
        if (!isShared_ || schedule.kind == Schedule::Kind::kroes)  // filters each iteration as a whole image
            return own_->film(area, revision, schedule);
        return std::unique_ptr<Accumulator>(std::make_unique<SharedAccumulator>(*own_, *work_, scene_, area, revision));
    }
    Result<void> trace(const Tile& tile, SampleRange samples, TileSums sums, const std::stop_token& stop) override {
        return isShared_ && work_->hasWorkers() ? traceTogether(*own_, *work_, scene_, tile, samples, sums, stop)
                                                : own_->trace(tile, samples, sums, stop);
    }
    std::shared_ptr<const denoise::Guide> guide(const denoise::GuideRays& rays, const std::stop_token& stop) override {
        return own_->guide(rays, stop);
    }
    bool trusts(const Contributors& contributors) const override { return !work_->isAnyUntrusted(contributors); }

  private:
    std::unique_ptr<Device> own_;
    std::shared_ptr<SharedWork> work_;
    Purpose purpose_;
    std::uint64_t scene_ = 0;  ///< number of the published scene; 0: none
    bool isShared_ = false;
};

/// Samples of an image for a file that are taken tile by tile: each tile comes back once. With more, an image that is
/// stopped would be too uneven, and fewer messages would not matter any more.
constexpr std::uint32_t kWholeSamples = 1024;

/// What a device that is alone asks for: as much of a block as a lease may have.
constexpr Ability kEverything{std::numeric_limits<double>::infinity(), 1};

/// Returns all samples of a film, to be rendered again because they can no longer be trusted.
std::vector<TileGoal> allOf(const TileProgress& progress) {
    std::vector<TileGoal> goals;
    for (const EvenTile& even : progress.evenTiles(progress.area()))
        goals.push_back({even.tile, progress.first(), even.next});
    return goals;
}

}  // namespace

std::unique_ptr<Device> shareDevice(std::unique_ptr<Device> own, std::shared_ptr<SharedWork> work, Purpose purpose) {
    return std::make_unique<SharedDevice>(std::move(own), std::move(work), purpose);
}

OrderSize SharedAccumulator::orderSize() const {
    const std::size_t workers = work_.countWorkers();
    if (workers == 0)
        return {};
    return {1, std::uint32_t(kSamplesPerBlock * (workers + 1)), kWholeSamples, work_.isTaken(scene_)};
}

std::vector<TileGoal> SharedAccumulator::goalsOf(const Tile& region, std::uint32_t n) const {
    std::vector<TileGoal> goals;
    for (const EvenTile& even : film_.progress().evenTiles(film_.progress().cellsAround(region)))
        goals.push_back({even.tile, even.next, even.next + n});
    return goals;
}

bool SharedAccumulator::discardUntrusted() {
    if (!work_.isAnyUntrusted(contributors_))
        return false;
    contributors_.clear();
    work_.discarded();
    film_.restart(film_.area(), film_.revision());
    return true;
}

Result<void> SharedAccumulator::accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) {
    std::vector<TileGoal> goals = goalsOf(region, n);
    for (;;) {
        const Result<bool> shared = together(goals, stop, {});
        if (!shared)
            return shared.error();
        Result<void> done = *shared ? Result<void>() : alone(goals, stop);
        if (!done || stop.stop_requested())
            return done;
        goals = allOf(film_.progress());
        if (!discardUntrusted())
            return {};
    }
}

Result<std::uint64_t> SharedAccumulator::extend(std::uint64_t had, std::uint32_t n, std::stop_token stop,
                                                const Extended& told) {
    const std::vector<TileGoal> goals = goalsOf(film_.area(), n);
    const Result<bool> shared = together(goals, stop, told);
    if (!shared)
        return shared.error();
    if (!*shared)
        if (Result<void> done = leaseByLease(goals, stop, told); !done)
            return done.error();
    if (discardUntrusted())
        return 0;
    return stop.stop_requested() ? film_.samplesPerPixel() : had + n;
}

Result<void> SharedAccumulator::alone(const std::vector<TileGoal>& goals, const std::stop_token& stop) {
    TileScheduler scheduler(goals, Split::tiles, 1);
    while (const std::optional<Portion> portion = scheduler.take(kOwnDevice, kEverything, 0)) {
        if (Result<void> traced = own_.trace(portion->tile, portion->samples, film_.sums(portion->tile), stop); !traced)
            return traced;
        if (stop.stop_requested())
            return {};
        film_.commit(portion->tile, portion->samples);
        scheduler.finish(portion->number);
    }
    return {};
}

Result<void> SharedAccumulator::leaseByLease(const std::vector<TileGoal>& goals, const std::stop_token& stop,
                                             const Extended& told) {
    SharedRequest request(film_, scene_, goals, Split::tiles, 1, CellCosts());
    while (const std::optional<Portion> portion = request.scheduler().take(kOwnDevice, kEverything, 0)) {
        Result<LeaseResult> result = traceLease(own_, request.leaseOf(*portion), stop);
        if (!result)
            return result.error();
        if (stop.stop_requested())
            return {};
        if (Result<void> taken = request.take(*std::move(result)); !taken)
            return taken;
        if (told)
            told(film_.samples());
    }
    return {};
}

Result<bool> SharedAccumulator::together(const std::vector<TileGoal>& goals, const std::stop_token& stop,
                                         const Extended& told) {
    if (!work_.hasWorkers() || !work_.begin(film_, scene_, goals, stop))
        return false;
    const Result<void> done = takeOwnPart(own_, work_, stop, told);
    contributors_.merge(work_.end());
    if (!done)
        return done.error();
    return true;
}

Result<void> SharedAccumulator::restart(const Tile& area, std::uint64_t revision) {
    contributors_.clear();
    return HostAccumulator::restart(area, revision);
}

}  // namespace pdr
