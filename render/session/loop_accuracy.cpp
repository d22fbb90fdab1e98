/// What the render thread finds out about how right its pictures are, and when.

#include <algorithm>
#include <utility>

#include "render/session/loop.h"

namespace pdr {

namespace {

/// Of the time, what may go into maps of the error, so that each is made often; where it takes more, seldom.
constexpr double kBesideShare = 0.01;
/// A denoised image is judged anew when the samples are so many times as many, and as soon as that takes no more than
/// this share of the time since the last one.
constexpr std::uint64_t kJudgedGrowth = 2;
constexpr double kJudgedShare = 0.04, kLeastJudgedGrowth = 1.09;
constexpr double kOftenMapped = 1.25, kSeldomMapped = 2;      ///< 1.25: a ninth of the errors is gone
/// Errors are counted anew when the samples are so many times as many; below kSamplesToEstimate, of which little is
/// said, at each doubling.
constexpr double kSurveyed = 1.09;

}  // namespace

/// At rest, where a smoothed picture is wanted: now and then, and where rendering holds. It takes longer than a picture
/// may: brightness does not wait for it.
Result<void> Session::Loop::judgeSmoothing(const RenderCommands::Iteration& step) {
    const bool isCheap = judgeSeconds_ <= kJudgedShare * (seconds_ - judgedAt_);
    const double growth = isCheap ? kLeastJudgedGrowth : double(kJudgedGrowth);
    const bool isDue = step.render ? smoothedView_.isDue(partSamples(), growth) : smoothedView_.isStale(partSamples());
    if (!canJudge() || !isDue || step.detour.stop_requested())
        return {};
    const double start = clock_();
    Result<void> judged =
        place_.film()->look([&](const Film& film) { smoothedView_.judge(film, partSamples(), step.detour); });
    judgeSeconds_ = secondsSince(start);
    seconds_ += judgeSeconds_;
    judgedAt_ = seconds_;
    return judged;
}

/// Where the image that is shown is still rough, if that is wanted of it.
Result<void> Session::Loop::mapErrors(const Display& display, const std::stop_token& stop) {
    if (!commands.errorMap() || coarse()) {
        errorMap_.clear();
        return {};
    }
    const double growth = mapSeconds_ <= kBesideShare * seconds_ ? kOftenMapped : kSeldomMapped;
    const std::uint64_t samples = shownOf_ == ErrorOf::denoised ? smoothedView_.judgedSamples() : partSamples();
    if (!errorMap_.isDue(shownOf_, samples, display.exposure, growth))
        return {};
    const double start = clock_(), exposure = double(display.exposure);
    Result<void> made = place_.film()->look([&](const Film& film) {
        std::optional<LevelErrorMap> map =
            shownOf_ == ErrorOf::denoised ? smoothedView_.errorMap(exposure) : std::nullopt;
        if (!map)
            map = levelErrorMap(film, exposure, stop);
        if (stop.stop_requested())
            return;
        errorMap_.keep(*std::move(map), shownOf_, samples, display.exposure);
    });
    seconds_ += secondsSince(start);
    mapSeconds_ += secondsSince(start);
    return made;
}

/// Whether the errors are to be counted anew; in between what was said of them last stands.
bool Session::Loop::isSurveyDue(const Display& asked) const {
    const double samples = sweep_.samples().mean, enough = double(kSamplesToEstimate);
    const double next = surveyed_.meanSamplesPerPixel < enough ? std::min(2 * surveyed_.meanSamplesPerPixel, enough)
                                                               : kSurveyed * surveyed_.meanSamplesPerPixel;
    return coarse() || !shownError_ || asked.exposure != historyExposure_ || samples >= next;
}

/// How good the image is that is made of a film of that status, as it was judged last.
ShownStatus Session::Loop::shown(const FilmStatus& film, bool denoised, float exposure) {
    return shownStatus(film, denoised, denoised ? smoothedView_.error(exposure) : std::nullopt);
}

/// What is known of it, if it is the film's own.
void Session::Loop::remember(DisplayedPicture& picture) {
    FilmStatus& status = picture.picture.status;
    if (!picture.picture.surveyed) {
        const FilmStatus counts = std::exchange(status, surveyed_);
        status.samplesPerPixel = counts.samplesPerPixel;
        status.meanSamplesPerPixel = counts.meanSamplesPerPixel;
        status.mostSamplesPerPixel = counts.mostSamplesPerPixel;
        status.health = counts.health;
    }
    shownError_.reset();
    if (coarse())
        return;
    const ShownStatus now = shown(status, picture.picture.smoothed, picture.display.exposure);
    shownError_ = now.status.displayError;
    shownOf_ = now.of;
    if (!picture.picture.surveyed)
        return;
    surveyed_ = status;
    if (std::exchange(historyExposure_, picture.display.exposure) != picture.display.exposure)
        history_.forgetErrors();
    history_.add(seconds_ - secondsAhead(), status, now);
}

/// That a part has had of the samples that the whole picture is still to get.
double Session::Loop::secondsAhead() const {
    const SampleCounts samples = sweep_.samples();
    return aheadSamples_ > 0 ? aheadSeconds_ / aheadSamples_ * double(samples.most - samples.least) : 0;
}

/// How good the region is, if there is one.
Result<void> Session::Loop::lookAtRegion(const Display& display) {
    if (coarse() || !region_.region())
        return {};
    const Tile tile = *region_.tile(place_.size());
    if (!region_.isDue(sweep_.samplesOf(tile), display.exposure))
        return {};
    const double start = clock_();
    const bool denoised = smoothedView_.better({display.exposure, smooths(display)}).smoothed;
    Result<void> looked = place_.film()->look([&](const Film& film) {
        region_.look(film, display.exposure, seconds_, denoised ? &smoothedView_ : nullptr);
    });
    seconds_ += secondsSince(start);
    return looked;
}

RenderCommands::Progress Session::Loop::progress() const {
    const double inRegion = region_.region() ? region_.error() : 0;
    return {shownError_ ? std::optional(std::max(*shownError_, inRegion)) : std::nullopt, seconds_,
            sweep_.samples().least};
}

/// What it takes until the whole picture is as good: what a part has had already counts when the rest gets there.
std::vector<QualityStep> Session::Loop::steps(ErrorOf of) const {
    std::vector<QualityStep> steps = history_.steps(of);
    const double ahead = secondsAhead();
    for (QualityStep& step : steps)
        if (!step.reached)
            for (double* seconds : {&step.seconds.value, &step.seconds.low, &step.seconds.high})
                *seconds += ahead;
    return steps;
}

}  // namespace pdr
