/// What the render thread does for a frame.

#include <algorithm>
#include <utility>

#include "render/session/loop.h"

namespace pdr {

namespace {

/// A launch at most, so that a change of devices, a pause or a look need not wait for a long frame.
constexpr double kLaunchSeconds = 0.25;
constexpr double kCheckpointSeconds = 2;      ///< between two of them, at least, ...
constexpr double kCheckpointFraction = 0.01;  ///< ... and the part of the time that they may take, at most
constexpr double kMeasureSeconds = 2;         ///< between two frames whose display is measured alone

}  // namespace

void Session::Loop::work(const RenderCommands::Iteration& step) {
    Result<void> done;
    if (step.render)
        done = accumulate(step);
    if (done && step.render && step.stop.stop_requested()) {
        place_.tearFilm();  // something newer is waiting
        return;
    }
    const bool frameEnds = !step.render || done_ >= wanted(step.pace);
    if (done && frameEnds && !coarse_)
        done = judgeSmoothing(step);
    if (done && !coarse_ && step.stop.stop_requested())
        return;  // the film is whole, but it will not be needed
    if (done && samples_ > 0 && frameEnds)
        done = show(step);
    if (place_.film() == nullptr)
        return;  // its picture was broken off
    if (done && samples_ > 0 && !coarse_)
        done = takeSnapshots();
    if (done && samples_ > 0 && !coarse_ && !place_.info().hostMemory)
        done = keepCheckpoint();
    if (!done)
        return failedOnDevice(done.error());
    if (coarse_ && !moving_ && !first_)
        beginFilm(false);
}

std::uint32_t Session::Loop::wanted(const FrameBudget& pace) const {
    return coarse_ ? kCoarseSamples : meter_.iterations(pace);
}

/// How many of `wanted` iterations to order at once.
std::uint32_t Session::Loop::launch(std::uint32_t wanted) const {
    const std::uint32_t left = wanted > done_ ? wanted - done_ : 1;
    const double pixels = double(place_.size().x) * place_.size().y;
    const double speed = done_ > 0 && frameSeconds_ > 0 ? done_ / frameSeconds_ : pixelsPerSecond_ / pixels;
    return std::uint32_t(std::clamp(speed * kLaunchSeconds, 1.0, double(left)));
}

Result<void> Session::Loop::accumulate(const RenderCommands::Iteration& step) {
    const double start = clock_();
    Accumulator& film = *place_.film();
    if (done_ == 0) {  // a frame begins
        const bool due = fresh_ || !meter_.settled() || secondsSince(measuredAt_) > kMeasureSeconds;
        measuring_ = film.maxInFlight() > 1 && !coarse_ && due;
        if (measuring_) {
            Result<std::vector<Picture>> before = takeAllBut(0);
            if (!before)
                return before.error();
            send(*std::move(before), wanted(step.pace));
        }
    }
    const double begin = measuring_ ? clock_() : start;
    const std::uint32_t n = launch(wanted(step.pace));
    if (Result<void> accumulated = film.accumulate(n, step.stop); !accumulated)
        return accumulated;
    done_ += n;
    samples_ += n;
    frameSeconds_ += secondsSince(begin);
    return {};
}

Display Session::Loop::wantedDisplay() {
    Display display = commands.display();
    display.smoothed = display.smoothed && canBeSmoothed(scene_);
    return display;
}

/// Where the hand rests, and a smoothed picture is wanted.
Result<void> Session::Loop::judgeSmoothing(const RenderCommands::Iteration& step) {
    if (!wantedDisplay().smoothed || !smoothedView_.isDue(samples_))
        return {};
    const double start = clock_();
    const Result<std::shared_ptr<const Film>> film = place_.film()->film();
    if (!film)
        return film.error();
    smoothedView_.judge(**film, step.stop);
    seconds_ += secondsSince(start);
    return {};
}

/// Orders a picture, and sends the ones that are due: this one at once where it is the first or coarse, or nothing
/// goes on behind.
Result<void> Session::Loop::show(const RenderCommands::Iteration& step) {
    Accumulator& film = *place_.film();
    const Display display = smoothedView_.better(wantedDisplay());
    exposure_ = display.exposure;
    const bool atOnce = fresh_ || coarse_ || measuring_ || !step.render;
    const double start = clock_();
    if (Result<void> ordered = film.resolve(display, step.stop); !ordered)
        return ordered;
    if (display.smoothed && step.stop.stop_requested()) {
        place_.tearFilm();
        return {};
    }
    ++waiting_;
    Result<std::vector<Picture>> pictures = takeAllBut(atOnce ? 0 : film.maxInFlight() - 1);
    if (!pictures)
        return pictures.error();
    const double displaySeconds = secondsSince(start);
    const std::uint32_t n = std::exchange(done_, 0);
    const double frameSeconds = std::exchange(frameSeconds_, 0);
    seconds_ += frameSeconds + displaySeconds;
    first_ = fresh_ = false;
    if (step.render) {
        if (film.maxInFlight() == 1)
            meter_.addFrame(n, frameSeconds, displaySeconds);
        else
            meter_.addPeriod(n, frameSeconds + displaySeconds);
        if (const double speed = meter_.iterationsPerSecond(); speed > 0)  // else no time has passed yet
            pixelsPerSecond_ = speed * place_.size().x * place_.size().y;
    }
    send(*std::move(pictures), wanted(step.pace));
    return measuring_ && step.render ? measureDisplay(display, n, frameSeconds + displaySeconds) : Result<void>();
}

Result<std::vector<Picture>> Session::Loop::takeAllBut(int left) {
    std::vector<Picture> pictures;
    while (waiting_ > left) {
        Result<Picture> picture = place_.film()->readback();
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
    const double start = clock_();
    if (Result<void> ordered = place_.film()->resolve(display); !ordered)
        return ordered;
    if (const Result<Picture> again = place_.film()->readback(); !again)
        return again.error();
    const double displaySeconds = secondsSince(start);
    meter_.addFrame(n, std::max(frameSeconds - displaySeconds, 0.0), displaySeconds);
    seconds_ += displaySeconds;
    measuring_ = false;
    measuredAt_ = clock_();
    return {};
}

Result<void> Session::Loop::takeSnapshots() {
    if (!commands.snapshotRequested(place_.revision()))
        return {};
    const Result<std::shared_ptr<const Film>> film = place_.film()->film();
    if (!film)
        return film.error();
    for (const RenderCommands::SnapshotRequest& order : commands.takeSnapshotRequests(place_.revision()))
        order.look(FilmView{**film, scene_, seconds_ + frameSeconds_});
    return {};
}

Result<void> Session::Loop::keepCheckpoint() {
    if (secondsSince(checkpointAt_) < std::max(kCheckpointSeconds, checkpointSeconds_ / kCheckpointFraction))
        return {};
    const double start = clock_();
    Result<std::shared_ptr<const Film>> film = place_.film()->film();
    if (!film)
        return film.error();
    checkpoint_ = *std::move(film);
    checkpointAt_ = clock_();
    checkpointSeconds_ = secondsSince(start);
    return {};
}

void Session::Loop::send(std::vector<Picture> pictures, std::uint32_t n) {
    for (Picture& picture : pictures) {
        auto frame = std::make_shared<Frame>();
        frame->revision = place_.revision();
        frame->camera = scene_.camera;
        frame->lookName = scene_.lookName;
        frame->estimator = scene_.estimator;
        frame->coarse = coarse_;
        frame->size = place_.size();
        frame->rgba = std::move(picture.rgba);
        frame->status = picture.status;
        frame->smoothed = picture.smoothed;
        if (picture.smoothed)
            frame->smoothedError = smoothedView_.error(exposure_);
        frame->seconds = seconds_;
        frame->iterationsPerSecond = meter_.iterationsPerSecond();
        frame->iterations = n;
        if (scene_.schedule.kind == Schedule::Kind::pd)  // else iterations hold their own display
            frame->efficiency = meter_.efficiency();
        frame->device = place_.info().name;
        frame->schedule = scene_.schedule;
        sink_(std::move(frame));
    }
}

}  // namespace pdr
