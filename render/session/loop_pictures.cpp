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
    const Display display = smoothedView_.better({asked.exposure, smooths(asked), isSurveyDue(asked)});
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
        seconds_ += displaySeconds;
        display_.breakOff();
        return {};
    }
    // Account for the time
    display_.markShown();
    const std::uint32_t n = within ? 0 : std::exchange(done_, 0);
    const double frameSeconds = within ? 0 : std::exchange(frameSeconds_, 0);
    seconds_ += frameSeconds + displaySeconds;
    if (adds)
        addTimes(n, frameSeconds, displaySeconds);
    if (adds && guided)
        ladder_.addGuidedDisplay(pixels(), displaySeconds);
    else if (adds && place_.film()->maxInFlight() == 1)
        ladder_.addDisplay(pixels(), displaySeconds);
    // Update errors, error map and region, then send
    for (DisplayedPicture& picture : *pictures)
        remember(picture);
    if (Result<void> mapped = mapErrors(asked, step.stop); !mapped)
        return mapped;
    if (Result<void> looked = lookAtRegion(asked); !looked)
        return looked;
    send(*std::move(pictures), wanted(step.pace));
    return measuring_ && adds ? measureDisplay(display, n, frameSeconds + displaySeconds) : Result<void>();
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
    seconds_ += displaySeconds;
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
    if (frame->smoothed) {
        frame->smoothedError = smoothedView_.error(frame->display.exposure);
        frame->lostLines = smoothedView_.lostLines();
    }
    frame->bias = biasFacts(scene_, frame->status, place_.info().name);
    frame->bias.measured = bias_.known(frame->display.exposure);
    frame->bias.isSmoothed = frame->smoothed;
    // Add times and forecasts
    frame->seconds = seconds_;
    if (!coarse()) {
        const ErrorOf of = shown(frame->status, frame->smoothed, frame->display.exposure).of;
        frame->steps = steps(of);
        frame->region = region_.status(frame->stop.levels);
        frame->history = history_.points(of);
    }
    frame->errorMap = errorMap_.map();
    frame->iterationsPerSecond = meter_.iterationsPerSecond();
    frame->iterations = n;
    if (scene_.schedule.kind == Schedule::Kind::pd)  // in other schedules iterations include their own display
        frame->efficiency = meter_.efficiency();
    frame->device = place_.info().name;
    frame->schedule = scene_.schedule;
    return frame;
}

}  // namespace pdr
