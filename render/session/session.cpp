#include "render/session/session.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "render/film/tone_map.h"
#include "render/kernel/random.h"
#include "render/scene/flatten.h"

namespace pdr {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kMovingSecondsPerFrame = 1.0 / 15;  ///< what a frame may take while the hand moves
constexpr std::uint32_t kMovingSamples = 4;          ///< of its pixels: fewer, calmer pixels are easier to follow
constexpr int kCoarsest = 8;                         ///< at most this many pixels of the film to one that is rendered

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

/// The render thread and what others ask of it.
class Session::Loop {
  public:
    Loop(std::unique_ptr<Device> device, FrameSink sink) : device_(std::move(device)), sink_(std::move(sink)) {
        thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
    }

    ~Loop() {
        thread_.request_stop();
        const std::lock_guard lock(mutex_);
        launch_.request_stop();
    }

    void submit(Scene scene, bool moving) {
        const std::lock_guard lock(mutex_);
        pending_ = Order{std::move(scene), moving};
        launch_.request_stop();
        changed_.notify_one();
    }

    void setDisplay(const Display& display) {
        const std::lock_guard lock(mutex_);
        display_ = display;
        displayChanged_ = true;
        changed_.notify_one();
    }

    void setIterationsPerFrame(int n) {
        const std::lock_guard lock(mutex_);
        iterationsPerFrame_ = std::clamp(n, 1, 10000);
    }

    void setPaused(bool paused) {
        const std::lock_guard lock(mutex_);
        paused_ = paused;
        changed_.notify_one();
    }

    void inspect(FilmLook look) {
        const std::lock_guard lock(mutex_);
        looks_.push_back(std::move(look));
        changed_.notify_one();
    }

  private:
    struct Order {
        Scene scene;
        bool moving;
    };

    /// What the thread does next, decided under the lock.
    struct Step {
        std::optional<Order> order;
        Display display;
        std::uint32_t iterations;
        bool render;
        std::stop_token stop;
    };

    void run(std::stop_token stop) {
        while (const std::optional<Step> step = nextStep(stop)) {
            if (step->order)
                begin(*step->order);
            if (!film_)
                continue;
            if (step->render && !sample(step->iterations, step->stop))
                continue;
            if (film_->samplesPerPixel() == 0)
                continue;
            show(step->display);
            for (const FilmLook& look : takeLooks())
                look(*film_, scene_, seconds_);
        }
    }

    /// Those who want to see the film; none while it is a coarse one.
    std::vector<FilmLook> takeLooks() {
        const std::lock_guard lock(mutex_);
        return moving_ ? std::vector<FilmLook>() : std::exchange(looks_, {});
    }

    std::optional<Step> nextStep(std::stop_token stop) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, stop, [this] {
            const bool lookable = film_ && !moving_ && !looks_.empty();
            return pending_ || displayChanged_ || lookable || (film_ && !paused_ && !finished_);
        });
        if (stop.stop_requested())
            return std::nullopt;
        launch_ = std::stop_source();
        Step step{std::move(pending_), display_, std::uint32_t(iterationsPerFrame_), false, launch_.get_token()};
        pending_.reset();
        displayChanged_ = false;
        // A new scene is always shown once, even while paused.
        step.render = step.order || (!paused_ && !finished_);
        return step;
    }

    /// Takes a new scene, coarser while the hand moves so that frames come soon.
    void begin(const Order& order) {
        finished_ = false;
        moving_ = order.moving;
        Scene scene = order.scene;
        if (moving_) {
            const double pixels = double(scene.film.x) * scene.film.y;
            const double affordable = std::max(pixelsPerSecond_ * kMovingSecondsPerFrame / kMovingSamples, 1.0);
            const int divider = std::clamp(int(std::ceil(std::sqrt(pixels / affordable))), 1, kCoarsest);
            scene.film = glm::max((scene.film + divider - 1) / divider, ivec2(1));
            scene.seed ^= mixBits(scene.revision);  // else the grain would stand still on a picture that moves
        }
        if (const Result<void> fits = scene.check(); !fits)
            return fail(order.scene.revision, fits.error());
        if (const Result<void> uploaded = device_->upload(flattener_.prepare(scene)); !uploaded)
            return fail(order.scene.revision, uploaded.error());
        film_.emplace(scene.film, order.scene.revision);
        scene_ = std::move(scene);
        seconds_ = 0;
        iterationsPerSecond_ = 0;
    }

    /// Adds up to n iterations; false when they were cancelled or failed and the film has nothing new to show.
    bool sample(std::uint32_t iterations, std::stop_token stop) {
        const Clock::time_point start = Clock::now();
        const Tile whole{0, 0, film_->size().x, film_->size().y};
        if (moving_)
            iterations = kMovingSamples;
        const std::uint32_t wanted = iterations;
        while (iterations > 0) {
            const SampleRange range = film_->nextSamples(iterations);
            const Result<void> rendered = device_->render(whole, range, film_->sums(whole), stop);
            if (!rendered) {
                fail(film_->revision(), rendered.error());
                return false;
            }
            if (stop.stop_requested()) {
                film_.reset();  // torn sums; the newer scene is waiting
                return false;
            }
            film_->commit(range);
            iterations -= range.count;
        }
        const double took = secondsSince(start);
        seconds_ += took;
        iterationsPerSecond_ = wanted / took;
        pixelsPerSecond_ = iterationsPerSecond_ * whole.width * whole.height;
        return true;
    }

    void show(const Display& display) {
        auto frame = std::make_shared<Frame>();
        frame->revision = film_->revision();
        frame->size = film_->size();
        frame->rgba = toneMap(*film_, display);
        frame->status = film_->status();
        frame->seconds = seconds_;
        frame->iterationsPerSecond = iterationsPerSecond_;
        sink_(std::move(frame));
    }

    void fail(std::uint64_t revision, const Error& error) {
        film_.reset();
        finished_ = true;
        auto frame = std::make_shared<Frame>();
        frame->revision = revision;
        frame->error = error.text();
        sink_(std::move(frame));
    }

    // Touched by the render thread only.
    std::unique_ptr<Device> device_;
    FrameSink sink_;
    Flattener flattener_;
    std::optional<Film> film_;
    Scene scene_;  ///< that film_ shows
    bool moving_ = false;
    bool finished_ = false;
    double seconds_ = 0, iterationsPerSecond_ = 0;
    double pixelsPerSecond_ = 5e6;  ///< a guess until the first launch was timed

    // Guarded by mutex_.
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<Order> pending_;
    std::stop_source launch_;
    Display display_;
    bool displayChanged_ = false;
    int iterationsPerFrame_ = 1;
    bool paused_ = false;
    std::vector<FilmLook> looks_;

    std::jthread thread_;
};

Session::Session(std::unique_ptr<Device> device, FrameSink sink)
    : loop_(std::make_unique<Loop>(std::move(device), std::move(sink))) {}

Session::~Session() = default;

void Session::submit(Scene scene, bool moving) {
    loop_->submit(std::move(scene), moving);
}

void Session::setDisplay(const Display& display) {
    loop_->setDisplay(display);
}

void Session::setIterationsPerFrame(int n) {
    loop_->setIterationsPerFrame(n);
}

void Session::setPaused(bool paused) {
    loop_->setPaused(paused);
}

void Session::inspect(FilmLook look) {
    loop_->inspect(std::move(look));
}

}  // namespace pdr
