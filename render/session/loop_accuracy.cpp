/// How the render thread determines the accuracy of its images, and when.

#include <algorithm>
#include <utility>

#include "render/session/loop.h"

namespace pdr {

namespace {

/// Fraction of the time up to which error maps are made often; if they take more, they are made seldom.
constexpr double kBesideShare = 0.01;
/// A denoised image is judged anew when its samples have grown by kJudgedGrowth, or already by kLeastJudgedGrowth if
/// the last judgement took at most kJudgedShare of the time since then.
constexpr std::uint64_t kJudgedGrowth = 2;
constexpr double kJudgedShare = 0.04, kLeastJudgedGrowth = 1.09;
constexpr double kOftenMapped = 1.25, kSeldomMapped = 2;  ///< growth of the samples; 1.25: the error falls by 1/9
/// Growth of the samples after which errors are counted anew. Below kSamplesToEstimate, where little is known of them,
/// they are counted at each doubling.
constexpr double kSurveyed = 1.09;

}  // namespace

/// Judges the error of the denoised image, if one is shown at rest: from time to time, and when rendering stops. This
/// takes longer than an image may, so a change of brightness interrupts it.
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

/// Updates the error map of the shown image, if one is requested and due.
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

/// Returns whether errors are to be counted anew. Until then the last counts remain valid.
bool Session::Loop::isSurveyDue(const Display& asked) const {
    const double samples = sweep_.samples().mean, enough = double(kSamplesToEstimate);
    const double next = surveyed_.meanSamplesPerPixel < enough ? std::min(2 * surveyed_.meanSamplesPerPixel, enough)
                                                               : kSurveyed * surveyed_.meanSamplesPerPixel;
    return coarse() || !shownError_ || asked.exposure != historyExposure_ || samples >= next;
}

/// Returns how good an image of a film is. `film`: status of the film. The error of a denoised image is that of the
/// last judgement.
ShownStatus Session::Loop::shown(const FilmStatus& film, bool denoised, float exposure) {
    return shownStatus(film, denoised, denoised ? smoothedView_.error(exposure) : std::nullopt);
}

/// Completes the status of an image with the errors counted last, and records its error unless the film is coarse.
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

/// Returns the time already spent on samples that a part of the image has and the rest is still to get [s].
double Session::Loop::secondsAhead() const {
    const SampleCounts samples = sweep_.samples();
    return aheadSamples_ > 0 ? aheadSeconds_ / aheadSamples_ * double(samples.most - samples.least) : 0;
}

/// Updates the status of the region, if there is one and it is due.
Result<void> Session::Loop::lookAtRegion(const Display& display) {
    if (coarse() || !region_.region())
        return {};
    const Tile tile = *region_.tile(place_.size());
    if (!region_.isDue(sweep_.samplesOf(tile), display.exposure))
        return {};
    const double start = clock_();
    const bool denoised = smoothedView_.better({display.exposure, smooths(display)}).smoothed;
    Result<void> looked = place_.film()->look(
        [&](const Film& film) { region_.look(film, display.exposure, seconds_, denoised ? &smoothedView_ : nullptr); });
    seconds_ += secondsSince(start);
    return looked;
}

ImageProgress Session::Loop::progress() const {
    const double inRegion = region_.region() ? region_.error() : 0;
    return {shownError_ ? std::optional(std::max(*shownError_, inRegion)) : std::nullopt, seconds_,
            sweep_.samples().least};
}

/// Returns the steps of the whole image. The time that a part is ahead is added to the steps to come, because it counts
/// only once the rest catches up.
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
