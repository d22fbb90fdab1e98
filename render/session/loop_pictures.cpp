/// How the render thread makes images of a film, and when it shows them.

#include <algorithm>
#include <utility>

#include "render/session/known_bias.h"
#include "render/session/loop.h"

namespace pdr {

/// Requests an image, and sends the images that are due. The requested image itself is sent at once if it is the first
/// one or coarse, is timed, or shows no new iterations. `adds`: it shows new iterations. Sends nothing if denoising was
/// interrupted because a newer request is waiting; if that is only another display, the film stays, and the next step
/// shows the previously denoised image on it.
Result<void> Session::Loop::show(const RenderCommands::Iteration& step, bool adds) {
    const Display asked = commands.display();
    const Display display = quality_.denoised().better(
        {asked.exposure, smooths(asked), quality_.isSurveyDue(sweep_.samples().mean, asked.exposure)});
    // Make the image
    const bool within = step.render && !adds;  // the current frame continues
    const bool atOnce = display_.isFresh() || coarse() || measuring_ || !adds;
    const double start = clock_();
    const std::stop_token& stop = step.redisplay || !givesWay() ? step.stop : step.detour;
    const bool guided = display.smoothed && display_.findGuide(place_, ResolutionLadder::finer(divider_), step.stop);
    Result<DisplayPipeline::Pictures> pictures =
        guided ? display_.makeOnGuide(place_, asked, adds) : display_.make(place_, asked, display, atOnce, stop);
    if (!pictures)
        return pictures.error();
    if (display.smoothed && step.stop.stop_requested()) {
        place_.tearFilm();
        return {};
    }
    const double displaySeconds = secondsSince(start);
    if (display.smoothed && stop.stop_requested()) {
        quality_.addSeconds(displaySeconds);
        display_.breakOff();
        return {};
    }
    // Account for the time
    display_.markShown();
    const std::uint32_t n = within ? 0 : std::exchange(done_, 0);
    const double frameSeconds = within ? 0 : std::exchange(frameSeconds_, 0);
    quality_.addSeconds(frameSeconds + displaySeconds);
    if (adds)
        addTimes(n, frameSeconds, displaySeconds);
    if (adds && guided)
        ladder_.addGuidedDisplay(pixels(), displaySeconds);
    else if (adds && place_.film()->maxInFlight() == 1)
        ladder_.addDisplay(pixels(), displaySeconds);
    // State the quality, then send
    for (DisplayedPicture& each : *pictures)
        quality_.record(each.picture, each.display.exposure, secondsAhead());
    if (Result<void> updated = updateQuality(asked, step.stop); !updated)
        return updated;
    send(*std::move(pictures), wanted(step.pace));
    return measuring_ && adds ? measureDisplay(display, n, frameSeconds + displaySeconds) : Result<void>();
}

/// Judges the error of the denoised image, if one is shown at rest and this is due. A change of brightness interrupts
/// it.
Result<void> Session::Loop::judge(const RenderCommands::Iteration& step) {
    if (!canJudge() || !quality_.isJudgementDue(partSamples(), step.render) || step.detour.stop_requested())
        return {};
    return quality_.judge(*place_.film(), partSamples(), step.detour);
}

/// Updates the error map, if one is requested, and the status of the region.
Result<void> Session::Loop::updateQuality(const Display& asked, const std::stop_token& stop) {
    Accumulator& film = *place_.film();
    if (!commands.errorMap())
        quality_.dropErrorMap();
    else if (Result<void> mapped = quality_.mapErrors(film, partSamples(), asked.exposure, stop); !mapped)
        return mapped;
    const std::optional<Tile> region = quality_.region().tile(place_.size());
    return region ? quality_.lookAtRegion(film, sweep_.samplesOf(*region), {asked.exposure, smooths(asked)})
                  : Result<void>();
}

/// Returns the time already spent on samples that a part of the image has and the rest is still to get [s].
double Session::Loop::secondsAhead() const {
    const SampleCounts samples = sweep_.samples();
    return aheadSamples_ > 0 ? aheadSeconds_ / aheadSamples_ * double(samples.most - samples.least) : 0;
}

/// Records the times of a frame of n iterations. If work runs asynchronously, only the sum of both is meaningful.
void Session::Loop::addTimes(std::uint32_t n, double iterationSeconds, double displaySeconds) {
    if (!isWhole(sweep_.part())) {
        aheadSeconds_ += iterationSeconds + displaySeconds;
        aheadSamples_ += n;
    }
    if (!wholeFrame_)
        return;
    if (place_.film()->maxInFlight() == 1) {
        meter_.addFrame(n, iterationSeconds, displaySeconds);
        ladder_.addFrame(n * pixels(), iterationSeconds);
    } else {
        meter_.addPeriod(n, iterationSeconds + displaySeconds);
        ladder_.addFrame(n * pixels(), iterationSeconds + displaySeconds);
    }
}

/// Shows the coarser film on another display.
Result<void> Session::Loop::showCoarser(const RenderCommands::Iteration& step) {
    const Display asked = commands.display();
    std::optional<DisplayedPicture> picture =
        display_.coarserPicture(asked, {asked.exposure, smooths(asked)}, step.stop);
    if (!picture)
        return {};
    auto frame = frameOf(*std::move(picture), ResolutionLadder::kSamples);
    frame->coarse = true;
    sink_(std::move(frame));
    return {};
}

/// Times the display of a frame alone. If work runs asynchronously, the duration of a call says nothing, so the frame
/// was made with nothing else in flight, in `frameSeconds`. Now only its display is repeated; the remaining time
/// is that of its n iterations.
Result<void> Session::Loop::measureDisplay(const Display& display, std::uint32_t n, double frameSeconds) {
    const double start = clock_();
    if (Result<void> ordered = place_.film()->resolve(display); !ordered)
        return ordered;
    if (const Result<Picture> again = place_.film()->readback(); !again)
        return again.error();
    const double displaySeconds = secondsSince(start);
    meter_.addFrame(n, std::max(frameSeconds - displaySeconds, 0.0), displaySeconds);
    quality_.addSeconds(displaySeconds);
    measuring_ = false;
    measuredAt_ = clock_();
    return {};
}

void Session::Loop::send(DisplayPipeline::Pictures pictures, std::uint32_t n) {
    for (DisplayedPicture& picture : pictures)
        sink_(frameOf(std::move(picture), n));
}

std::shared_ptr<Frame> Session::Loop::frameOf(DisplayedPicture picture, std::uint32_t n) {
    auto frame = std::make_shared<Frame>();
    // Describe the scene
    frame->revision = place_.revision();
    frame->camera = scene_.camera;
    frame->lookName = scene_.lookName;
    frame->maskAwaited = scene_.maskAwaited;
    frame->notShown = scene_.mask ? scene_.mask->hidden() : Text();
    frame->clip = scene_.clip;
    frame->estimator = scene_.estimator;
    // State the progress
    frame->coarse = coarse();
    const StopRequest stop = commands.stopRequest();
    frame->stop = stop.rule;
    frame->reached = stop.isMet(progress());
    // Add the image and its quality
    frame->size = picture.size;
    frame->display = picture.display;
    frame->rgba = std::move(picture.picture.rgba);
    frame->status = picture.picture.status;
    frame->smoothed = picture.picture.smoothed;
    quality_.describe(*frame, secondsAhead());
    frame->bias = biasFacts(scene_, frame->status, place_.info().name);
    frame->bias.measured = bias_.known(frame->display.exposure);
    frame->bias.isSmoothed = frame->smoothed;
    // Add how it was made
    frame->iterationsPerSecond = meter_.iterationsPerSecond();
    frame->iterations = n;
    if (scene_.schedule.kind == Schedule::Kind::pd)  // in other schedules iterations include their own display
        frame->efficiency = meter_.efficiency();
    frame->device = place_.info().name;
    frame->schedule = scene_.schedule;
    return frame;
}

}  // namespace pdr
