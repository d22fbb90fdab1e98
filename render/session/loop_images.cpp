/// How the render thread makes images of a film, and when it shows them.

#include <utility>

#include "render/session/known_bias.h"
#include "render/session/loop.h"
#include "render/smooth/non_local_means.h"

namespace pdr {

/// Requests an image, and sends the images that are due. The requested image itself is sent at once if it is the first
/// one or coarse, is timed, or shows no new iterations. `adds`: it shows new iterations. Sends nothing if denoising was
/// interrupted because a newer request is waiting; if that is only another display, the film stays, and the next step
/// shows the previously denoised image on it.
Result<void> Session::Loop::show(const RenderCommands::Iteration& step, bool adds) {
    const Display asked = commands.display();
    Display wanted = asked.withDenoised(smooths(asked));
    wanted.surveyed = quality_.isSurveyDue(scheduler_.samples().mean, asked);
    const Display display = quality_.denoised().better(wanted);
    // Make the image
    const bool within = step.render && !adds;  // the current frame continues
    const bool atOnce = display_.isFresh() || coarse() || scheduler_.isTimed() || !adds;
    const std::stop_token& stop = step.redisplay || !givesWay() ? step.stop : step.detour;
    const bool edited = showsEdit(display), featured = showsFeatures(step, display, adds);
    const double start = times_.sampled = clock_();
    const bool guided = display.denoised && !edited &&
                        display_.findGuide(place_, ResolutionLadder::finer(scheduler_.divider()), step.stop);
    Result<DisplayPipeline::Images> images = edited || featured ? makeHelped(asked, display, adds, stop)
                                             : guided           ? display_.makeOnGuide(place_, asked, adds)
                                                                : display_.make(place_, asked, display, atOnce, stop);
    if (!images)
        return images.error();
    if (display.denoised && step.stop.stop_requested())
        return {};
    const double displaySeconds = clock_() - start;
    if (display.denoised && stop.stop_requested()) {
        quality_.addSeconds(displaySeconds);
        display_.breakOff();
        return {};
    }
    // Account for the time
    display_.markShown();
    const FrameScheduler::Iterations taken = within ? FrameScheduler::Iterations() : scheduler_.endFrame();
    quality_.addSeconds(taken.seconds + displaySeconds);
    if (adds)
        scheduler_.addImage({taken, displaySeconds, overlaps(), guided, edited});
    // State the quality, then send
    for (DisplayedImage& each : *images)
        quality_.record(each.image, each.display, scheduler_.secondsAhead());
    if (Result<void> updated = updateQuality(asked, step.stop); !updated)
        return updated;
    send(*std::move(images), scheduler_.wanted(demand(step.pace)));
    return scheduler_.isTimed() && adds ? timeDisplay(display, taken.n, taken.seconds + displaySeconds)
                                        : Result<void>();
}

/// Seeks features of the full film where they would help an image of new samples, unless another display waits; returns
/// whether the image is made on them. Their time is no image's, since they are made once.
bool Session::Loop::showsFeatures(const RenderCommands::Iteration& step, const Display& display, bool adds) {
    if (!display.denoised || !seeksFeatures())
        return false;
    if (adds)
        findFeatures(step.detour);
    return features_.helps(scheduler_.samples().least);
}

void Session::Loop::findFeatures(const std::stop_token& stop) {
    const double start = clock_();
    features_.find(place_, scheduler_.samples().least, stop);
    quality_.addSeconds(clock_() - start);
}

/// Judges the error of the denoised image, if one is shown at rest and this is due. A change of brightness interrupts
/// it.
Result<void> Session::Loop::judge(const RenderCommands::Iteration& step) {
    if (!coarse() && edits_.letGo(partSamples()))
        quality_.denoised().clear();  // it was the image made with the old one
    if (!canJudge() || !quality_.isJudgementDue(partSamples(), step.render) || step.detour.stop_requested())
        return {};
    if (seeksFeatures())
        features_.find(place_, scheduler_.samples().least, step.detour);
    if (EditedView::canKeep(scene_))
        edits_.findGuide(place_, step.detour);
    return quality_.judge(*place_.film(), partSamples(), step.detour,
                          edits_.smoother(partSamples(), features_.smoother(scheduler_.samples().least)));
}

/// Judges the image that has just been shown, and shows it again with the error.
Result<void> Session::Loop::judgeShown(const RenderCommands::Iteration& step) {
    const std::uint64_t before = quality_.denoised().judgedSamples();
    if (Result<void> judged = judge(step); !judged)
        return judged;
    const bool isNew = quality_.denoised().judgedSamples() != before && !step.detour.stop_requested();
    return isNew ? show(step, false) : Result<void>();
}

/// Updates the error map, if one is requested, and the status of the region.
Result<void> Session::Loop::updateQuality(const Display& asked, const std::stop_token& stop) {
    Accumulator& film = *place_.film();
    if (!commands.errorMap())
        quality_.dropErrorMap();
    else if (Result<void> mapped = quality_.mapErrors(film, partSamples(), asked, stop); !mapped)
        return mapped;
    const std::optional<Tile> region = quality_.region().tile(place_.size());
    const Display display = asked.withDenoised(smooths(asked));
    return region ? quality_.lookAtRegion(film, scheduler_.sweep().samplesOf(*region), display) : Result<void>();
}

/// Shows the coarser film on another display.
Result<void> Session::Loop::showCoarser(const RenderCommands::Iteration& step) {
    const Display asked = commands.display();
    const Display display = asked.withDenoised(smooths(asked));
    std::optional<DisplayedImage> image = display_.coarserImage(asked, display, step.stop);
    if (!image)
        return {};
    auto frame = frameOf(*std::move(image), ResolutionLadder::kSamples);
    frame->coarse = true;
    sink_(std::move(frame));
    return {};
}

/// Times the display of a frame alone. If work runs asynchronously, the duration of a call says nothing, so the frame
/// was made with nothing else in flight, in `frameSeconds`. Now only its display is repeated; the remaining time
/// is that of its n iterations.
Result<void> Session::Loop::timeDisplay(const Display& display, std::uint32_t n, double frameSeconds) {
    const double start = clock_();
    if (Result<void> ordered = place_.film()->resolve(display); !ordered)
        return ordered;
    if (const Result<Image> again = place_.film()->readback(); !again)
        return again.error();
    const double displaySeconds = clock_() - start;
    scheduler_.addTimedFrame(n, frameSeconds, displaySeconds);
    quality_.addSeconds(displaySeconds);
    return {};
}

void Session::Loop::send(DisplayPipeline::Images images, std::uint32_t n) {
    for (DisplayedImage& image : images) {
        std::shared_ptr<Frame> frame = frameOf(std::move(image), n);
        frame->times = times_;
        frame->times.made = clock_();
        if (!frame->coarse) {
            shown_ = frame;
            returning_ = nullptr;
        }
        sink_(std::move(frame));
    }
}

void Session::Loop::label(Frame& frame) {
    frame.revision = scene_.revision;
    frame.lookName = scene_.lookName;
    frame.maskAwaited = scene_.maskAwaited;
    const StopRequest stop = commands.stopRequest();
    frame.stop = stop.rule;
    frame.reached = stop.isMet(progress());
    frame.device = place_.info().name;
}

std::shared_ptr<Frame> Session::Loop::frameOf(DisplayedImage image, std::uint32_t n) {
    auto frame = std::make_shared<Frame>();
    // Describe the scene
    label(*frame);
    frame->camera = scene_.camera;
    frame->notShown = notShown_;
    frame->clip = scene_.clip;
    frame->ctDenoised = isCtDenoised(*scene_.volume);
    frame->estimator = scene_.estimator;
    // State the progress
    frame->coarse = coarse();
    // Add the image and its quality
    frame->size = image.size;
    frame->display = image.display;
    frame->rgba = std::move(image.image.rgba);
    frame->status = image.image.status;
    frame->denoised = image.image.denoised;
    quality_.describe(*frame, scheduler_.secondsAhead());
    frame->bias = biasFacts(scene_, frame->status, place_.info().name);
    frame->bias.measured = bias_.known(frame->display);
    frame->bias.isDenoised = frame->denoised;
    // Add how it was made
    frame->iterationsPerSecond = scheduler_.timer().iterationsPerSecond();
    frame->iterations = n;
    if (scene_.schedule.kind == Schedule::Kind::pd)  // in other schedules iterations include their own display
        frame->efficiency = scheduler_.timer().efficiency();
    frame->schedule = scene_.schedule;
    return frame;
}

}  // namespace pdr
