/// The work of the render thread for one frame: samples, snapshots and checkpoints.

#include <utility>

#include "render/session/loop.h"

namespace pdr {

void Session::Loop::work(const RenderCommands::Iteration& step) {
    // Show an existing image, on another display
    if (showReturning())
        return finish(step, {});
    brightens_ = step.redisplay && !display_.awaitsFirst() && !coarse() && smooths(commands.display());
    if (step.redisplay && (!display_.awaitsFirst() || display_.hasCoarser()))
        return finish(step, display_.awaitsFirst() ? showCoarser(step) : show(step, false));
    // Replace a coarse film by the next finer one
    if (step.render && coarse() && !display_.awaitsFirst())
        beginFiner(step.detour);
    if (place_.film() == nullptr)
        return;
    // Take samples
    const bool keeps = isWorthKeeping();  // then the launch ends first: half of one would leave no film to keep
    Result<void> done;
    if (step.render && !display_.isBroken())
        done = accumulate(step.pace, keeps ? std::stop_token() : step.stop);
    if (done && step.render && step.stop.stop_requested()) {  // a newer request is waiting
        if (!keeps)
            place_.tearFilm();
        return;
    }
    if (done && !display_.awaitsFirst() && step.detour.stop_requested())
        return finish(step, done);  // another display: the next step shows the existing image on it
    // Judge and show the image at the end of a frame
    const bool frameEnds = !step.render || display_.isBroken() || scheduler_.isComplete(demand(step.pace));
    // The first full images do not wait for their judgement, which takes longer than they do
    const bool isEarly = canJudge() && (display_.awaitsFirst() || partSamples() <= ResolutionLadder::kSamples);
    if (done && frameEnds && !isEarly)
        done = judge(step);
    if (done && givesWay() && step.detour.stop_requested()) {
        if (frameEnds)
            display_.breakOff();
        return finish(step, done);  // an interrupted judgement is repeated later
    }
    if (done && hasSamples() && frameEnds)
        done = show(step, step.render && scheduler_.hasIterations());
    if (done && isEarly && frameEnds && !display_.awaitsFirst())
        done = judgeShown(step);
    finish(step, std::move(done));
}

/// Ends a step: takes snapshots and a checkpoint, prepares for the next edit, and measures the bias, where due. If
/// `done` is an error, handles that instead.
void Session::Loop::finish(const RenderCommands::Iteration& step, Result<void> done) {
    if (done && step.stop.stop_requested())
        return;  // its image may have been interrupted
    if (done && canSnapshot())
        done = takeSnapshots();
    const bool isLosable = hasSamples() && !isHalfMade() && !coarse() && !place_.info().hostMemory;
    if (done && isLosable && checkpoint_.isDue())
        done = checkpoint_.take(*place_.film());
    if (done && canSnapshot() && !step.detour.stop_requested())
        done = prepareEdit(step.detour);
    if (done && canSnapshot() && step.render && bias_.isDue() && !step.detour.stop_requested())
        done = bias_.measure(place_, scene_, scheduler_.samples().least, commands.display(), step.detour);
    if (!done)
        failedOnDevice(done.error());
}

/// Measures the costs of effects: between launches if nothing else is requested, and all the time while rendering is
/// stopped.
void Session::Loop::measureEffects(const RenderCommands::Iteration& step) {
    if (!canSnapshot())
        return;
    effectCosts_.follow(scene_, commands.display());
    if (effectCosts_.hasWork() && (step.idle || effectCosts_.isDue()) && !step.detour.stop_requested())
        effectCosts_.step(step.detour);
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
    scheduler_.beginFrame(nextPart(), overlaps(), display_.isFresh());
    if (!scheduler_.isTimed())
        return {};
    Result<DisplayPipeline::Images> before = display_.takeAllBut(place_, 0);
    if (!before)
        return before.error();
    send(*std::move(before), scheduler_.wanted(demand(pace)));
    return {};
}

Result<void> Session::Loop::accumulate(const FrameBudget& pace, const std::stop_token& stop) {
    if (scheduler_.isBetweenFrames())
        if (Result<void> begun = beginFrame(pace); !begun)
            return begun;
    const bool inPieces = place_.info().hostMemory && scene_.schedule.kind == Schedule::Kind::pd;
    const double start = clock_();
    const Sweep::Order order = scheduler_.next(demand(pace), inPieces);
    if (Result<void> accumulated = place_.film()->accumulate(order.tile, order.n, stop); !accumulated)
        return accumulated;
    scheduler_.took(order, clock_() - start);
    if (keepsFirst() && !stop.stop_requested())
        edits_.keepFirst(place_, scheduler_.samples());
    return {};
}

Result<void> Session::Loop::takeSnapshots() {
    if (!commands.snapshotRequested(place_.revision()))
        return {};
    return place_.film()->look([&](const Film& film) {
        const FilmView view{film,
                            scene_,
                            quality_.seconds() + scheduler_.frameSeconds(),
                            place_.info().name,
                            bias_.known(commands.display()),
                            commands.stopRequest().rule,
                            judgesFilm() ? &quality_.denoised() : nullptr};
        const std::uint64_t judged = quality_.denoised().judgedSamples();
        for (const RenderCommands::SnapshotRequest& order : commands.takeSnapshotRequests(place_.revision()))
            order.look(view);
        if (quality_.denoised().judgedSamples() != judged)
            display_.refresh();
    });
}

}  // namespace pdr
