/// The work of the render thread for one frame: samples, snapshots and checkpoints.

#include <algorithm>
#include <utility>

#include "render/session/loop.h"

namespace pdr {

namespace {

/// Longest duration of a launch, so that a change of brightness or device, a pause or a snapshot need not wait for a
/// long frame; and of a piece of a launch, if it can be split. On a busy machine both take several times as long.
constexpr double kLaunchSeconds = 0.06, kPieceSeconds = 0.015;
constexpr double kMeasureSeconds = 2;  ///< between two frames whose display is timed alone

}  // namespace

void Session::Loop::work(const RenderCommands::Iteration& step) {
    // Show the existing image on another display
    brightens_ = step.redisplay && !display_.awaitsFirst() && !coarse() && smooths(commands.display());
    if (step.redisplay && (!display_.awaitsFirst() || display_.hasCoarser()))
        return finish(step, display_.awaitsFirst() ? showCoarser(step) : show(step, false));
    // Replace a coarse film by the next finer one
    if (step.render && coarse() && !display_.awaitsFirst())
        beginFiner();
    if (place_.film() == nullptr)
        return;
    // Take samples
    Result<void> done;
    if (step.render && !display_.isBroken())
        done = accumulate(step);
    if (done && step.render && step.stop.stop_requested()) {
        place_.tearFilm();  // a newer request is waiting
        return;
    }
    if (done && !display_.awaitsFirst() && step.detour.stop_requested())
        return finish(step, done);  // another display: the next step shows the existing image on it
    // Judge and show the image at the end of a frame
    const bool frameEnds =
        !step.render || display_.isBroken() || (!sweep_.isHalfMade() && (done_ >= wanted(step.pace) || late()));
    if (done && frameEnds)
        done = judge(step);
    if (done && givesWay() && step.detour.stop_requested()) {
        if (frameEnds)
            display_.breakOff();
        return finish(step, done);  // an interrupted judgement is repeated later
    }
    if (done && sweep_.samples().least > 0 && frameEnds)
        done = show(step, step.render);
    finish(step, std::move(done));
}

/// Ends a step: takes snapshots, a checkpoint and bias measurements where due. If `done` is an error, handles that
/// instead.
void Session::Loop::finish(const RenderCommands::Iteration& step, Result<void> done) {
    if (done && place_.film() == nullptr)
        return;  // its image was interrupted
    if (done && canSnapshot())
        done = takeSnapshots();
    const bool isLosable = sweep_.samples().least > 0 && !sweep_.isHalfMade() && !coarse() && !place_.info().hostMemory;
    if (done && isLosable && checkpoint_.isDue())
        done = checkpoint_.take(*place_.film());
    if (done && canSnapshot() && step.render && bias_.isDue() && !step.detour.stop_requested())
        done = bias_.measure(place_, scene_, sweep_.samples().least, commands.display().exposure, step.detour);
    if (!done)
        failedOnDevice(done.error());
}

/// Measures the costs of effects: between launches if nothing else is requested, and all the time while rendering is
/// stopped.
void Session::Loop::measureEffects(const RenderCommands::Iteration& step) {
    if (!canSnapshot())
        return;
    ledger_.follow(scene_, commands.display());
    if (ledger_.hasWork() && (step.idle || ledger_.isDue()) && !step.detour.stop_requested())
        ledger_.step(step.detour);
}

/// Returns the iterations of the next frame. Their number rises as the sampled part gets smaller than the image.
std::uint32_t Session::Loop::wanted(const FrameBudget& pace) const {
    const double larger = pixels() / partPixels();
    const std::uint32_t usual = coarse() ? ResolutionLadder::kSamples : std::uint32_t(larger * meter_.iterations(pace));
    return std::max(usual, std::uint32_t(display_.coarserSamples().value_or(0)));
}

/// Returns whether the first image of an edit must be shown now, with fewer samples than planned.
bool Session::Loop::late() const {
    return coarse() && !display_.hasCoarser() && frameSeconds_ >= ladder_.secondsForSamples(pixels());
}

/// Returns how many of `wanted` iterations to request at once. The first iteration of a first image shows how many are
/// in time.
std::uint32_t Session::Loop::launch(std::uint32_t wanted) const {
    const bool hurries = coarse() && !display_.hasCoarser();
    if (hurries && done_ == 0)
        return 1;
    const double seconds = hurries ? ladder_.secondsForSamples(pixels()) - frameSeconds_ : kLaunchSeconds;
    const std::uint32_t left = wanted > done_ ? wanted - done_ : 1;
    const double speed = done_ > 0 && frameSeconds_ > 0 ? done_ / frameSeconds_ : ladder_.speed() / partPixels();
    return std::uint32_t(std::clamp(speed * seconds, 1.0, double(left)));
}

/// Returns the number of pixels to sample at once: all if the device and schedule do not allow pieces, else as many as
/// take kPieceSeconds.
double Session::Loop::piecePixels() const {
    const bool inPieces = place_.info().hostMemory && scene_.schedule.kind == Schedule::Kind::pd;
    return inPieces ? ladder_.speed() * kPieceSeconds : pixels();
}

/// Returns the part of the image that the next frame samples: the region while it is not within the target, once there
/// is an image around it; else the whole image.
Tile Session::Loop::nextPart() {
    const bool inParts = !display_.awaitsFirst() && !coarse() && scene_.schedule.kind == Schedule::Kind::pd;
    return inParts && quality_.region().isFirst(commands.stopRequest().rule.levels)
               ? *quality_.region().tile(place_.size())
               : wholeImage(place_.size());
}

/// Begins a frame, whose passes all sample the same part. If its display is to be timed, sends all images in flight
/// first.
Result<void> Session::Loop::beginFrame(const FrameBudget& pace) {
    sweep_.choose(nextPart());
    wholeFrame_ = isWhole(sweep_.part()) && isEven();
    const bool due = display_.isFresh() || !meter_.settled() || secondsSince(measuredAt_) > kMeasureSeconds;
    measuring_ = wholeFrame_ && place_.film()->maxInFlight() > 1 && !coarse() && due;
    if (!measuring_)
        return {};
    Result<DisplayPipeline::Pictures> before = display_.takeAllBut(place_, 0);
    if (!before)
        return before.error();
    send(*std::move(before), wanted(pace));
    return {};
}

Result<void> Session::Loop::accumulate(const RenderCommands::Iteration& step) {
    if (done_ == 0 && !sweep_.isHalfMade())
        if (Result<void> begun = beginFrame(step.pace); !begun)
            return begun;
    const double start = clock_();
    if (!sweep_.isHalfMade())
        sweep_.begin(launch(wanted(step.pace)));
    const Sweep::Order order = sweep_.next(piecePixels());
    if (Result<void> accumulated = place_.film()->accumulate(order.tile, order.n, step.stop); !accumulated)
        return accumulated;
    done_ += sweep_.took(order);
    frameSeconds_ += secondsSince(start);
    return {};
}

Result<void> Session::Loop::takeSnapshots() {
    if (!commands.snapshotRequested(place_.revision()))
        return {};
    return place_.film()->look([&](const Film& film) {
        const FilmView view{film,
                            scene_,
                            quality_.seconds() + frameSeconds_,
                            place_.info().name,
                            bias_.known(commands.display().exposure),
                            commands.stopRequest().rule,
                            canJudge() ? &quality_.denoised() : nullptr};
        const std::uint64_t judged = quality_.denoised().judgedSamples();
        for (const RenderCommands::SnapshotRequest& order : commands.takeSnapshotRequests(place_.revision()))
            order.look(view);
        if (quality_.denoised().judgedSamples() != judged)
            display_.refresh();
    });
}

}  // namespace pdr
