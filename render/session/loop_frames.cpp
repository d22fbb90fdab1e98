/// What the render thread does for a frame.

#include <algorithm>
#include <utility>

#include "render/session/loop.h"

namespace pdr {

namespace {

/// A launch at most, so that brightness, a change of devices, a pause or a look need not wait for a long frame.
constexpr double kLaunchSeconds = 0.06;
constexpr double kCheckpointSeconds = 2;      ///< between two of them, at least, ...
constexpr double kCheckpointFraction = 0.01;  ///< ... and the part of the time that they may take, at most
constexpr double kMeasureSeconds = 2;         ///< between two frames whose display is measured alone

}  // namespace

void Session::Loop::work(const RenderCommands::Iteration& step) {
    brightens_ = step.redisplay && !first_ && !coarse() && smooths(commands.display());
    if (step.redisplay && (!first_ || coarser_))
        return finish(step, first_ ? showCoarser(step) : show(step, false));
    if (step.render && coarse() && !first_)
        beginFiner();
    if (place_.film() == nullptr)
        return;
    Result<void> done;
    if (step.render)
        done = accumulate(step);
    if (done && step.render && step.stop.stop_requested()) {
        place_.tearFilm();  // something newer is waiting
        return;
    }
    const bool frameEnds = !step.render || (row_ == 0 && (done_ >= wanted(step.pace) || late()));
    if (done && frameEnds)
        done = judgeSmoothing(step);
    if (done && samples_ > 0 && frameEnds)
        done = show(step, step.render);
    finish(step, std::move(done));
}

/// The end of a step: what else is wanted of the film, unless something went wrong.
void Session::Loop::finish(const RenderCommands::Iteration& step, Result<void> done) {
    if (done && place_.film() == nullptr)
        return;  // its picture was broken off
    if (done && canSnapshot())
        done = takeSnapshots();
    if (done && samples_ > 0 && row_ == 0 && !coarse() && !place_.info().hostMemory)
        done = keepCheckpoint();
    if (done && canSnapshot() && step.render)
        done = measureBias(step);
    if (!done)
        failedOnDevice(done.error());
}

/// Between launches, where nothing else is wanted; all the time while rendering holds.
void Session::Loop::measureEffects(const RenderCommands::Iteration& step) {
    if (!canSnapshot())
        return;
    ledger_.follow(scene_, commands.display());
    if (ledger_.hasWork() && (step.idle || ledger_.isDue()) && !step.stop.stop_requested())
        ledger_.step(step.stop);
}

/// Iterations of the next frame.
std::uint32_t Session::Loop::wanted(const FrameBudget& pace) const {
    const std::uint32_t usual = coarse() ? ResolutionLadder::kSamples : meter_.iterations(pace);
    return first_ && coarser_ ? std::max(usual, std::uint32_t(coarser_->samplesPerPixel())) : usual;
}

/// Whether the first picture of an edit must be shown with fewer samples than it should have.
bool Session::Loop::late() const {
    return coarse() && !coarser_ && frameSeconds_ >= ladder_.secondsForSamples(pixels());
}

/// How many of `wanted` iterations to order at once. The first one of a first picture tells how many are in time.
std::uint32_t Session::Loop::launch(std::uint32_t wanted) const {
    const bool hurries = coarse() && !coarser_;
    if (hurries && done_ == 0)
        return 1;
    const double seconds = hurries ? ladder_.secondsForSamples(pixels()) - frameSeconds_ : kLaunchSeconds;
    const std::uint32_t left = wanted > done_ ? wanted - done_ : 1;
    const double speed = done_ > 0 && frameSeconds_ > 0 ? done_ / frameSeconds_ : ladder_.speed() / pixels();
    return std::uint32_t(std::clamp(speed * seconds, 1.0, double(left)));
}

/// The part of an iteration to order at once, in rows: all where that does not take long, or cannot be had in parts.
int Session::Loop::bandRows() const {
    const ivec2 size = place_.size();
    if (!place_.info().hostMemory || scene_.schedule.kind != Schedule::Kind::pd)
        return size.y;
    const double rows = ladder_.speed() * kLaunchSeconds / size.x;
    return rows < size.y ? std::max(int(rows) / kFilmCell, 1) * kFilmCell : size.y;
}

Result<void> Session::Loop::accumulate(const RenderCommands::Iteration& step) {
    const double start = clock_();
    Accumulator& film = *place_.film();
    if (done_ == 0) {  // a frame begins
        const bool due = fresh_ || !meter_.settled() || secondsSince(measuredAt_) > kMeasureSeconds;
        measuring_ = film.maxInFlight() > 1 && !coarse() && due;
        if (measuring_) {
            Result<std::vector<DisplayedPicture>> before = takeAllBut(0);
            if (!before)
                return before.error();
            send(*std::move(before), wanted(step.pace));
        }
    }
    const double begin = measuring_ ? clock_() : start;
    const std::uint32_t n = row_ > 0 ? 1 : launch(wanted(step.pace));
    const Tile part = n == 1 ? nextBand() : wholeImage(place_.size());
    if (Result<void> accumulated = film.accumulate(part, n, step.stop); !accumulated)
        return accumulated;
    row_ = (part.y + part.height) % place_.size().y;
    if (row_ == 0) {
        done_ += n;
        samples_ += n;
    }
    frameSeconds_ += secondsSince(begin);
    return {};
}

Tile Session::Loop::nextBand() const {
    const ivec2 size = place_.size();
    return {0, row_, size.x, std::min(bandRows(), size.y - row_)};
}

Result<void> Session::Loop::takeSnapshots() {
    if (!commands.snapshotRequested(place_.revision()))
        return {};
    return place_.film()->look([&](const Film& film) {
        const FilmView view{film,
                            scene_,
                            seconds_ + frameSeconds_,
                            place_.info().name,
                            knownBias(commands.display().exposure),
                            commands.target()};
        for (const RenderCommands::SnapshotRequest& order : commands.takeSnapshotRequests(place_.revision()))
            order.look(view);
    });
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

}  // namespace pdr
