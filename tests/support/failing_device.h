#pragma once
/// The CPU in the role of a GPU: lost when a test says so, too small for a volume, slow, or with work that goes on
/// behind the caller's back.

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "render/device/cpu/host_gpu.h"
#include "render/device/gpu/gpu_device.h"

namespace pdr::test {

/// What goes wrong, and how long things take. A test may change it while a device renders.
struct Mishaps {
    static constexpr int kNever = 1 << 30;
    // Calls that go well before one fails; after it every call fails, as of a GPU that is gone.
    std::atomic<int> uploads = kNever, films = kNever, iterates = kNever, shows = kNever, takes = kNever;
    std::atomic<bool> tooSmall = false;  ///< uploads are refused, and nothing else

    std::atomic<double> iterationSeconds = 0;  ///< what an iteration takes, at least
    std::atomic<double> displaySeconds = 0;    ///< what a picture takes from show() to take(), at least
    int ahead = 1;                             ///< > 1: iterate() and show() return at once, and take() waits

    std::atomic<bool> gone = false;
    std::atomic<int> filmsRead = 0;  ///< calls of LiveFilm::film()

    /// Called first by each verb, with its name: "upload", "film", "resume", "iterate", "show", "take", "read". It may
    /// throw. Set before the device is handed over.
    std::function<void(const std::string&)> before = [](const std::string&) {};

    Result<void> call(std::atomic<int>& left) {
        if (gone || left-- <= 0)
            gone = true;
        return gone ? Error{"the device is lost", "", "Look after its cables."} : Result<void>();
    }
};

class FailingFilm final : public LiveFilm {
  public:
    FailingFilm(std::unique_ptr<LiveFilm> film, std::shared_ptr<Mishaps> mishaps)
        : film_(std::move(film)), mishaps_(std::move(mishaps)) {}

    Result<void> iterate(std::uint32_t n, std::stop_token stop) override {
        mishaps_->before("iterate");
        if (Result<void> well = mishaps_->call(mishaps_->iterates); !well)
            return well;
        Result<void> iterated = film_->iterate(n, stop);
        spend(n * mishaps_->iterationSeconds, stop);
        return iterated;
    }

    Result<void> show(const Display& display) override {
        mishaps_->before("show");
        if (Result<void> well = mishaps_->call(mishaps_->shows); !well)
            return well;
        spend(mishaps_->displaySeconds, {});
        if (Result<void> shown = film_->show(display); !shown)
            return shown;
        Result<Picture> picture = film_->take();  // whatever the inner film's own ahead() is
        if (!picture)
            return picture.error();
        pictures_.push_back({busyUntil_, *std::move(picture)});
        return {};
    }

    Result<Picture> take() override {
        mishaps_->before("take");
        if (Result<void> well = mishaps_->call(mishaps_->takes); !well)
            return well.error();
        std::this_thread::sleep_until(pictures_.front().first);
        Picture oldest = std::move(pictures_.front().second);
        pictures_.pop_front();
        return oldest;
    }

    int ahead() const override { return mishaps_->ahead; }

    Result<std::shared_ptr<const Film>> film() override {
        mishaps_->before("read");
        ++mishaps_->filmsRead;
        if (Result<void> well = mishaps_->call(mishaps_->films); !well)
            return well.error();
        return film_->film();
    }

    Result<void> resume(const Film& film) override {
        mishaps_->before("resume");
        return film_->resume(film);
    }

  private:
    using Clock = std::chrono::steady_clock;

    void spend(double seconds, const std::stop_token& stop) {
        const auto time = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
        busyUntil_ = std::max(Clock::now(), busyUntil_) + time;
        while (mishaps_->ahead == 1 && Clock::now() < busyUntil_ && !stop.stop_requested())
            std::this_thread::sleep_until(std::min(busyUntil_, Clock::now() + std::chrono::milliseconds(10)));
    }

    std::unique_ptr<LiveFilm> film_;
    std::shared_ptr<Mishaps> mishaps_;
    Clock::time_point busyUntil_;                                 ///< when all that was ordered is done
    std::deque<std::pair<Clock::time_point, Picture>> pictures_;  ///< and when they arrive
};

class FailingDevice final : public Device {
  public:
    explicit FailingDevice(std::shared_ptr<Mishaps> mishaps) : mishaps_(std::move(mishaps)) {}

    DeviceInfo info() const override { return {"failing", "for tests", false}; }

    Result<void> upload(std::shared_ptr<const PreparedScene> scene) override {
        mishaps_->before("upload");
        if (mishaps_->tooSmall)
            return Error{"the volume needs 9.3 GB and 6.0 GB are free", "", "Choose a smaller part of it."};
        if (Result<void> well = mishaps_->call(mishaps_->uploads); !well)
            return well;
        return inner_.upload(std::move(scene));
    }

    Result<void> render(const Tile& tile, SampleRange samples, TileSums sums, std::stop_token stop) override {
        return inner_.render(tile, samples, sums, stop);
    }

    Result<std::unique_ptr<LiveFilm>> film(ivec2 size, std::uint64_t revision, const Schedule& schedule) override {
        mishaps_->before("film");
        Result<std::unique_ptr<LiveFilm>> film = inner_.film(size, revision, schedule);
        if (!film)
            return film;
        return std::unique_ptr<LiveFilm>(std::make_unique<FailingFilm>(*std::move(film), mishaps_));
    }

  private:
    std::shared_ptr<Mishaps> mishaps_;
    GpuDevice<HostGpu> inner_{DeviceInfo{}, 0, 1};  ///< it makes the bounds of scenes itself, as a GPU does
};

inline std::unique_ptr<Device> failing(const std::shared_ptr<Mishaps>& mishaps) {
    return std::make_unique<FailingDevice>(mishaps);
}

}  // namespace pdr::test
