#pragma once
/// A CPU device in the role of a GPU: lost when a test says so, too small for a volume, slow, or with work that
/// continues after a call has returned.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "render/device/emulated/emulated_gpu.h"
#include "tests/support/devices/fake_clock.h"

namespace pdr::test {

/// Failures and durations of a FailingDevice. A test may change them while the device renders.
struct Mishaps {
    static constexpr int kNever = 1 << 30;
    // Calls that succeed before one fails; after it every call fails, as with a GPU that is gone.
    std::atomic<int> uploads = kNever, films = kNever, accumulates = kNever, resolves = kNever, readbacks = kNever;
    std::atomic<bool> tooSmall = false;  ///< uploads are refused, and nothing else

    std::atomic<double> iterationSeconds = 0;  ///< minimum time of an iteration of a whole image
    std::atomic<double> sampleSeconds = 0;     ///< and of a sample of one pixel
    std::atomic<double> displaySeconds = 0;    ///< minimum time of an image from resolve() to readback()
    int maxInFlight = 1;                       ///< > 1: accumulate() and resolve() return at once, and readback() waits
    std::shared_ptr<FakeClock> clock;          ///< clock that these durations advance; null: the wall clock
    std::atomic<double> goneAt = 1e300;        ///< time on that clock at which the device is lost

    std::atomic<bool> gone = false;
    std::atomic<bool> brokenOff = false;  ///< the last accumulate() was asked to stop
    std::atomic<int> filmsRead = 0;       ///< number of calls of Accumulator::film()

    /// Function that each call invokes first, with its name: "upload", "film", "guide", "resume", "accumulate",
    /// "resolve", "readback", "read". It may throw. Set it before the device is passed on.
    std::function<void(const std::string&)> before = [](const std::string&) {};

    Result<void> call(std::atomic<int>& left) {
        if (gone || left-- <= 0 || now() >= goneAt)
            gone = true;
        return gone ? Error{"the device is lost", "", "Look after its cables.", ErrorKind::deviceLost} : Result<void>();
    }
    double now() const { return clock ? clock->seconds() : steadySeconds(); }
    /// Waits until `moment`; on the wall clock only until a stop is requested.
    void wait(double moment, const std::stop_token& stop) {
        if (clock)
            return clock->advanceTo(moment);
        for (double left = moment - now(); left > 0 && !stop.stop_requested(); left = moment - now())
            std::this_thread::sleep_for(std::chrono::duration<double>(std::min(left, 0.01)));
    }
};

class FailingAccumulator final : public Accumulator {
  public:
    FailingAccumulator(std::unique_ptr<Accumulator> film, std::shared_ptr<Mishaps> mishaps)
        : film_(std::move(film)), mishaps_(std::move(mishaps)) {}

    using Accumulator::accumulate;
    using Accumulator::resolve;

    Tile area() const override { return film_->area(); }

    Result<void> accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) override {
        mishaps_->before("accumulate");
        if (Result<void> well = mishaps_->call(mishaps_->accumulates); !well)
            return well;
        Result<void> accumulated = film_->accumulate(region, n, stop);
        const double part = double(region.width) * region.height / (double(area().width) * area().height);
        const double samples = n * double(region.width) * region.height;
        spend(n * part * mishaps_->iterationSeconds + samples * mishaps_->sampleSeconds, stop);
        mishaps_->brokenOff = stop.stop_requested();
        return accumulated;
    }

    Result<void> resolve(const Display& display, std::stop_token stop) override {
        mishaps_->before("resolve");
        if (Result<void> well = mishaps_->call(mishaps_->resolves); !well)
            return well;
        spend(mishaps_->displaySeconds, {});
        if (Result<void> shown = film_->resolve(display, stop); !shown)
            return shown;
        Result<Image> image = film_->readback();  // whatever the inner film's own maxInFlight() is
        if (!image)
            return image.error();
        images_.push_back({busyUntil_, *std::move(image)});
        return {};
    }

    Result<Image> readback() override {
        mishaps_->before("readback");
        if (Result<void> well = mishaps_->call(mishaps_->readbacks); !well)
            return well.error();
        mishaps_->wait(images_.front().first, {});
        Image oldest = std::move(images_.front().second);
        images_.pop_front();
        return oldest;
    }

    int maxInFlight() const override { return mishaps_->maxInFlight; }

    Result<std::shared_ptr<const Film>> film() override {
        mishaps_->before("read");
        ++mishaps_->filmsRead;
        if (Result<void> well = mishaps_->call(mishaps_->films); !well)
            return well.error();
        return film_->film();
    }

    Result<std::shared_ptr<const Film>> putAway() override {
        mishaps_->before("read");
        if (Result<void> well = mishaps_->call(mishaps_->films); !well)
            return well.error();
        return film_->putAway();
    }

    Result<void> resume(const Film& film) override {
        mishaps_->before("resume");
        return film_->resume(film);
    }

    Result<void> restart(const Tile& area, std::uint64_t revision) override {
        mishaps_->before("film");
        images_.clear();
        busyUntil_ = 0;  // work for the last scene is dropped
        return film_->restart(area, revision);
    }

  private:
    void spend(double seconds, const std::stop_token& stop) {
        busyUntil_ = std::max(mishaps_->now(), busyUntil_) + seconds;
        if (mishaps_->maxInFlight == 1)
            mishaps_->wait(busyUntil_, stop);
    }

    std::unique_ptr<Accumulator> film_;
    std::shared_ptr<Mishaps> mishaps_;
    double busyUntil_ = 0;                         ///< time at which all requested work is done
    std::deque<std::pair<double, Image>> images_;  ///< images, each with the time at which it arrives
};

class FailingDevice final : public Device {
  public:
    explicit FailingDevice(std::shared_ptr<Mishaps> mishaps) : mishaps_(std::move(mishaps)) {}

    DeviceInfo info() const override { return {"failing", "for tests", false}; }

    using Device::film;

    Result<void> upload(const Scene& scene) override {
        mishaps_->before("upload");
        if (mishaps_->tooSmall)
            return Error{"the volume needs 9.3 GB and 6.0 GB are free", "", "Choose a smaller part of it.",
                         ErrorKind::memory};
        if (Result<void> well = mishaps_->call(mishaps_->uploads); !well)
            return well;
        return inner_->upload(scene);
    }
    Result<void> unload() override {
        mishaps_->before("upload");
        return inner_->unload();
    }

    Result<std::unique_ptr<Accumulator>> film(const Tile& area, std::uint64_t revision,
                                              const Schedule& schedule) override {
        mishaps_->before("film");
        Result<std::unique_ptr<Accumulator>> film = inner_->film(area, revision, schedule);
        if (!film)
            return film;
        return std::unique_ptr<Accumulator>(std::make_unique<FailingAccumulator>(*std::move(film), mishaps_));
    }

    std::shared_ptr<const denoise::Guide> guide(const denoise::GuideRays& rays, const std::stop_token& stop) override {
        mishaps_->before("guide");
        return inner_->guide(rays, stop);
    }

  private:
    std::shared_ptr<Mishaps> mishaps_;
    std::unique_ptr<Device> inner_ = makeEmulatedGpu(1);  ///< it makes the bounds of scenes itself, as a GPU does
};

inline std::unique_ptr<Device> failing(const std::shared_ptr<Mishaps>& mishaps) {
    return std::make_unique<FailingDevice>(mishaps);
}

}  // namespace pdr::test
