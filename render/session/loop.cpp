#include "render/session/loop.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "render/kernel/random.h"

namespace pdr {

namespace {

constexpr double kMovingSecondsPerFrame = 1.0 / 15;  ///< what a frame may take while the hand moves
constexpr std::uint32_t kMovingSamples = 4;          ///< of its pixels: fewer, calmer pixels are easier to follow
constexpr int kCoarsest = 8;                         ///< at most this many pixels of the film to one that is rendered

/// A launch at most, so that a change of devices, a pause or a look need not wait for a long frame.
constexpr double kLaunchSeconds = 0.25;
constexpr double kCheckpointSeconds = 2;   ///< between two of them, at least, ...
constexpr double kCheckpointShare = 0.01;  ///< ... and the part of the time that they may take, at most
constexpr double kMeasureSeconds = 2;      ///< between two frames whose display is measured alone

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string capital(std::string text) {
    if (!text.empty())
        text.front() = char(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
}

/// With a full stop at its end.
std::string ended(std::string text) {
    if (!text.empty() && text.back() != '.')
        text += '.';
    return text;
}

}  // namespace

Session::Loop::Loop(std::unique_ptr<Device> device, FrameSink sink, DeviceOpener fallback)
    : sink_(std::move(sink)), fallback_(std::move(fallback)), place_(std::move(device)) {
    thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
}

Session::Loop::~Loop() {
    thread_.request_stop();
    orders.cancel();
}

void Session::Loop::run(std::stop_token stop) {
    while (const std::optional<Orders::Step> step = orders.next(situation(), stop)) {
        if (step->device)
            switchTo(step->device);
        if (step->schedule)
            restart(*step->schedule);
        if (step->order)
            begin(*step->order);
        if (place_.film() != nullptr)
            work(*step);
    }
}

Orders::Situation Session::Loop::situation() const {
    const bool film = place_.film() != nullptr;
    return {.film = film,
            .first = film && first_,
            .unshown = film && samples_ > 0 && (done_ > 0 || waiting_ > 0 || fresh_),
            .lookable = film && !moving_ && samples_ > 0};
}

/// Takes a new scene, coarser while the hand moves so that frames come soon.
void Session::Loop::begin(const Orders::SceneOrder& order) {
    moving_ = order.moving;
    Scene scene = moving_ ? coarse(order.scene) : order.scene;
    if (const Result<void> fits = scene.check(); !fits) {
        place_.forget();
        return fail(order.scene.revision, fits.error().text());
    }
    scene_ = std::move(scene);
    startOver();
    if (const Result<void> begun = place_.begin(scene_, schedule_); !begun)
        refused(begun.error());
}

void Session::Loop::restart(const Schedule& schedule) {
    schedule_ = schedule;
    if (!place_.hasScene())
        return;
    startOver();
    if (const Result<void> begun = place_.restart(schedule_); !begun)
        refused(begun.error());
}

Scene Session::Loop::coarse(Scene scene) const {
    const double pixels = double(scene.film.x) * scene.film.y;
    const double affordable = std::max(pixelsPerSecond_ * kMovingSecondsPerFrame / kMovingSamples, 1.0);
    const int divider = std::clamp(int(std::ceil(std::sqrt(pixels / affordable))), 1, kCoarsest);
    scene.film = glm::max((scene.film + divider - 1) / divider, ivec2(1));
    scene.seed ^= mixBits(scene.revision);  // else the grain would stand still on a picture that moves
    return scene;
}

void Session::Loop::switchTo(const DeviceOpener& open) {
    const std::string old = spoken(place_.info());
    std::shared_ptr<const Film> from = checkpoint_;
    std::optional<Error> lost;  // when the old device does not hand out its film
    if (place_.film() != nullptr && samples_ > 0) {
        if (const auto film = place_.film()->film())
            from = *film;
        else
            lost = film.error();
    }
    Result<std::unique_ptr<Device>> device = open();
    const Result<void> moved = device ? place_.moveTo(*std::move(device), from.get()) : device.error();
    if (moved) {
        onFallback_ = false;
        return goOnFrom(std::move(from));
    }
    if (lost)
        return stopped(*lost);
    notify("The other device cannot be used: " + ended(moved.error().text()) + " The picture goes on on " + old + ".");
}

void Session::Loop::work(const Orders::Step& step) {
    Result<void> done;
    if (step.render)
        done = iterate(step);
    if (done && step.render && step.stop.stop_requested()) {
        place_.dropFilm();  // torn sums; something newer is waiting
        return;
    }
    const bool frameEnds = !step.render || done_ >= wanted(step.pace);
    if (done && samples_ > 0 && frameEnds)
        done = show(step);
    if (done && samples_ > 0 && !moving_)
        done = letOthersLook();
    if (done && samples_ > 0 && !moving_ && !place_.info().hostMemory)
        done = keepCheckpoint();
    if (!done)
        stopped(done.error());
}

std::uint32_t Session::Loop::wanted(const Pace& pace) const {
    return moving_ ? kMovingSamples : meter_.iterations(pace);
}

/// How many of `wanted` iterations to order at once.
std::uint32_t Session::Loop::launch(std::uint32_t wanted) const {
    const std::uint32_t left = wanted > done_ ? wanted - done_ : 1;
    const double pixels = double(place_.size().x) * place_.size().y;
    const double speed = done_ > 0 && frameSeconds_ > 0 ? done_ / frameSeconds_ : pixelsPerSecond_ / pixels;
    return std::uint32_t(std::clamp(speed * kLaunchSeconds, 1.0, double(left)));
}

Result<void> Session::Loop::iterate(const Orders::Step& step) {
    const Clock::time_point start = Clock::now();
    LiveFilm& film = *place_.film();
    if (done_ == 0) {  // a frame begins
        const bool due = fresh_ || !meter_.settled() || secondsSince(measuredAt_) > kMeasureSeconds;
        measuring_ = film.ahead() > 1 && !moving_ && due;
        if (measuring_) {
            Result<std::vector<Picture>> before = takeAllBut(0);
            if (!before)
                return before.error();
            send(*std::move(before), wanted(step.pace));
        }
    }
    const Clock::time_point begin = measuring_ ? Clock::now() : start;
    const std::uint32_t n = launch(wanted(step.pace));
    if (Result<void> iterated = film.iterate(n, step.stop); !iterated)
        return iterated;
    done_ += n;
    samples_ += n;
    frameSeconds_ += secondsSince(begin);
    return {};
}

/// Orders a picture, and sends the ones that are due: this one at once where it is the first, the hand moves, or
/// nothing goes on behind.
Result<void> Session::Loop::show(const Orders::Step& step) {
    LiveFilm& film = *place_.film();
    const bool atOnce = fresh_ || moving_ || measuring_ || !step.render;
    const Clock::time_point start = Clock::now();
    if (Result<void> ordered = film.show(step.display); !ordered)
        return ordered;
    ++waiting_;
    Result<std::vector<Picture>> pictures = takeAllBut(atOnce ? 0 : film.ahead() - 1);
    if (!pictures)
        return pictures.error();
    const double displaySeconds = secondsSince(start);
    const std::uint32_t n = std::exchange(done_, 0);
    const double frameSeconds = std::exchange(frameSeconds_, 0);
    seconds_ += frameSeconds + displaySeconds;
    first_ = fresh_ = false;
    if (step.render) {
        if (film.ahead() == 1)
            meter_.addFrame(n, frameSeconds, displaySeconds);
        else
            meter_.addPeriod(n, frameSeconds + displaySeconds);
        pixelsPerSecond_ = meter_.iterationsPerSecond() * place_.size().x * place_.size().y;
    }
    send(*std::move(pictures), wanted(step.pace));
    return measuring_ && step.render ? measureDisplay(step.display, n, frameSeconds + displaySeconds) : Result<void>();
}

Result<std::vector<Picture>> Session::Loop::takeAllBut(int left) {
    std::vector<Picture> pictures;
    while (waiting_ > left) {
        Result<Picture> picture = place_.film()->take();
        if (!picture)
            return picture.error();
        --waiting_;
        pictures.push_back(*std::move(picture));
    }
    return pictures;
}

/// Where work goes on behind, what a call takes says nothing. So a frame was made with nothing beside it, in
/// `frameSeconds`; now its display alone once more, and what is left are its n iterations.
Result<void> Session::Loop::measureDisplay(const Display& display, std::uint32_t n, double frameSeconds) {
    const Clock::time_point start = Clock::now();
    if (Result<void> ordered = place_.film()->show(display); !ordered)
        return ordered;
    if (const Result<Picture> again = place_.film()->take(); !again)
        return again.error();
    const double displaySeconds = secondsSince(start);
    meter_.addFrame(n, std::max(frameSeconds - displaySeconds, 0.0), displaySeconds);
    seconds_ += displaySeconds;
    measuring_ = false;
    measuredAt_ = Clock::now();
    return {};
}

Result<void> Session::Loop::letOthersLook() {
    if (!orders.lookAsked())
        return {};
    const Result<std::shared_ptr<const Film>> film = place_.film()->film();
    if (!film)
        return film.error();
    for (const FilmLook& look : orders.takeLooks())
        look({**film, scene_, schedule_, seconds_ + frameSeconds_});
    return {};
}

Result<void> Session::Loop::keepCheckpoint() {
    if (secondsSince(checkpointAt_) < std::max(kCheckpointSeconds, checkpointSeconds_ / kCheckpointShare))
        return {};
    const Clock::time_point start = Clock::now();
    Result<std::shared_ptr<const Film>> film = place_.film()->film();
    if (!film)
        return film.error();
    checkpoint_ = *std::move(film);
    checkpointAt_ = Clock::now();
    checkpointSeconds_ = secondsSince(start);
    return {};
}

void Session::Loop::send(std::vector<Picture> pictures, std::uint32_t n) {
    for (Picture& picture : pictures) {
        auto frame = std::make_shared<Frame>();
        frame->revision = place_.revision();
        frame->size = place_.size();
        frame->rgba = std::move(picture.rgba);
        frame->status = picture.status;
        frame->seconds = seconds_;
        frame->iterationsPerSecond = meter_.iterationsPerSecond();
        frame->iterations = n;
        if (schedule_.kind == Schedule::Kind::pd)  // else iterations hold their own display
            frame->efficiency = meter_.efficiency();
        frame->device = place_.info().name;
        frame->schedule = schedule_;
        sink_(std::move(frame));
    }
}

/// Of another scene, or the same from its beginning.
void Session::Loop::startOver() {
    goOnFrom(nullptr);
    seconds_ = 0;
}

/// The film in hand is a new one, which holds what `film` holds.
void Session::Loop::goOnFrom(std::shared_ptr<const Film> film) {
    samples_ = film ? film->samplesPerPixel() : 0;
    first_ = first_ || samples_ == 0;
    done_ = 0;
    waiting_ = 0;
    fresh_ = true;
    frameSeconds_ = 0;
    meter_.clear();
    checkpoint_ = std::move(film);
    checkpointAt_ = Clock::now();
    checkpointSeconds_ = 0;
}

void Session::Loop::recover(const std::string& reason) {
    const std::string what = ended(capital(reason));
    if (onFallback_ || !fallback_)
        return fail(place_.revision(), what);
    Result<std::unique_ptr<Device>> device = fallback_();
    const Result<void> moved = device ? place_.moveTo(*std::move(device), checkpoint_.get()) : device.error();
    if (!moved)
        return fail(place_.revision(), what + " Nor can the picture go on elsewhere: " + moved.error().text());
    onFallback_ = true;
    goOnFrom(std::exchange(checkpoint_, nullptr));
    notify(what + " The picture goes on on " + spoken(place_.info()) + ".");
}

void Session::Loop::fail(std::uint64_t revision, const std::string& sentence) {
    place_.dropFilm();
    auto frame = std::make_shared<Frame>();
    frame->revision = revision;
    frame->error = sentence;
    sink_(std::move(frame));
}

void Session::Loop::notify(const std::string& sentences) {
    auto frame = std::make_shared<Frame>();
    frame->revision = scene_.revision;
    frame->notice = sentences;
    sink_(std::move(frame));
}

}  // namespace pdr
