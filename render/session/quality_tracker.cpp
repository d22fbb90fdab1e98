/// How the errors of a film's images are determined, and when.

#include "render/session/quality_tracker.h"

#include <algorithm>
#include <utility>

#include "render/device/accumulator.h"

namespace pdr {

namespace {

/// Fraction of the time up to which error maps are made often; if they take more, they are made seldom.
constexpr double kBesideShare = 0.01;
/// A denoised image is judged anew when its samples have grown by kJudgedGrowth, or already by kLeastJudgedGrowth if
/// the last judgement took at most kJudgedShare of the time since then.
constexpr double kJudgedShare = 0.04, kJudgedGrowth = 2, kLeastJudgedGrowth = 1.09;
constexpr double kOftenMapped = 1.25, kSeldomMapped = 2;  ///< growth of the samples; 1.25: the error falls by 1/9
/// Growth of the samples after which errors are counted anew. Below kSamplesToEstimate, where little is known of them,
/// they are counted at each doubling.
constexpr double kSurveyed = 1.09;

}  // namespace

void QualityTracker::clear() {
    shownError_.reset();
    shownOf_ = ErrorOf::film;
    surveyed_ = {};
    history_.clear();
    historyTone_ = Tone(0);
    denoised_.clear();
    judgeSeconds_ = judgedAt_ = 0;
    errorMap_.clear();
    mapSeconds_ = 0;
    region_.clear();
}

void QualityTracker::startOver(bool isCoarse) {
    clear();
    isCoarse_ = isCoarse;
    seconds_ = 0;
}

bool QualityTracker::isJudgementDue(std::uint64_t samples, bool renders) const {
    if (!renders)
        return denoised_.isStale(samples);
    const bool isCheap = judgeSeconds_ <= kJudgedShare * (seconds_ - judgedAt_);
    return denoised_.isDue(samples, isCheap ? kLeastJudgedGrowth : kJudgedGrowth);
}

Result<void> QualityTracker::judge(Accumulator& film, std::uint64_t samples, const std::stop_token& stop,
                                   const HalfSmoother& smoother) {
    const double start = clock_();
    Result<void> judged = film.look([&](const Film& content) { denoised_.judge(content, samples, stop, smoother); });
    judgeSeconds_ = clock_() - start;
    seconds_ += judgeSeconds_;
    judgedAt_ = seconds_;
    return judged;
}

bool QualityTracker::isSurveyDue(double meanSamples, const Tone& tone) const {
    const double last = surveyed_.meanSamplesPerPixel, enough = double(kSamplesToEstimate);
    const double next = last < enough ? std::min(2 * last, enough) : kSurveyed * last;
    return isCoarse_ || !shownError_ || tone != historyTone_ || meanSamples >= next;
}

/// Returns how good an image of a film is. `film`: status of the film. The error of a denoised image is that of the
/// last judgement.
ShownStatus QualityTracker::shown(const FilmStatus& film, bool isDenoised, const Tone& tone) {
    return shownStatus(film, isDenoised, isDenoised ? denoised_.error(tone) : std::nullopt);
}

/// Completes the status of an image whose errors were not counted.
void QualityTracker::completeStatus(Image& image) const {
    if (image.surveyed)
        return;
    FilmStatus& status = image.status;
    const FilmStatus counts = std::exchange(status, surveyed_);
    status.samplesPerPixel = counts.samplesPerPixel;
    status.meanSamplesPerPixel = counts.meanSamplesPerPixel;
    status.mostSamplesPerPixel = counts.mostSamplesPerPixel;
    status.health = counts.health;
}

void QualityTracker::record(Image& image, const Tone& tone, double secondsAhead) {
    completeStatus(image);
    shownError_.reset();
    if (isCoarse_)
        return;
    const ShownStatus now = shown(image.status, image.denoised, tone);
    shownError_ = now.status.displayError;
    shownOf_ = now.of;
    if (!image.surveyed)
        return;
    surveyed_ = image.status;
    if (std::exchange(historyTone_, tone) != tone)
        history_.forgetErrors();
    history_.add(seconds_ - secondsAhead, image.status, now);
}

Result<void> QualityTracker::mapErrors(Accumulator& film, std::uint64_t samples, const Tone& tone,
                                       const std::stop_token& stop) {
    if (isCoarse_) {
        errorMap_.clear();
        return {};
    }
    const bool ofDenoised = shownOf_ == ErrorOf::denoised;
    const double growth = mapSeconds_ <= kBesideShare * seconds_ ? kOftenMapped : kSeldomMapped;
    const std::uint64_t mapped = ofDenoised ? denoised_.judgedSamples() : samples;
    if (!errorMap_.isDue(shownOf_, mapped, tone, growth))
        return {};
    const double start = clock_();
    Result<void> made = film.look([&](const Film& content) {
        std::optional<LevelErrorMap> map = ofDenoised ? denoised_.errorMap(tone) : std::nullopt;
        if (!map)
            map = levelErrorMap(content, tone, stop);
        if (!stop.stop_requested())
            errorMap_.keep(*std::move(map), shownOf_, mapped, tone);
    });
    const double spent = clock_() - start;
    seconds_ += spent;
    mapSeconds_ += spent;
    return made;
}

Result<void> QualityTracker::lookAtRegion(Accumulator& film, std::uint64_t samples, const Display& display) {
    if (isCoarse_ || !region_.isDue(samples, display))
        return {};
    const double start = clock_();
    DenoisedView* const denoised = denoised_.better(display).denoised ? &denoised_ : nullptr;
    Result<void> looked = film.look([&](const Film& content) { region_.look(content, display, seconds_, denoised); });
    seconds_ += clock_() - start;
    return looked;
}

ImageProgress QualityTracker::progress(std::uint64_t samples) const {
    const double inRegion = region_.region() ? region_.error() : 0;
    return {shownError_ ? std::optional(std::max(*shownError_, inRegion)) : std::nullopt, seconds_, samples};
}

/// Returns the steps of the whole image. The seconds ahead are added to the steps to come, because that time counts
/// only once the rest catches up.
std::vector<QualityStep> QualityTracker::steps(ErrorOf of, double secondsAhead) const {
    std::vector<QualityStep> steps = history_.steps(of);
    for (QualityStep& step : steps)
        if (!step.reached)
            for (double* seconds : {&step.seconds.value, &step.seconds.low, &step.seconds.high})
                *seconds += secondsAhead;
    return steps;
}

void QualityTracker::describe(Frame& frame, double secondsAhead) {
    const Tone tone = frame.display;
    frame.seconds = seconds_;
    frame.errorMap = errorMap_.map();
    if (frame.denoised) {
        frame.denoisedError = denoised_.error(tone);
        frame.lostLines = denoised_.lostLines();
    }
    if (isCoarse_)
        return;
    const ErrorOf of = shown(frame.status, frame.denoised, tone).of;
    frame.steps = steps(of, secondsAhead);
    frame.history = history_.points(of);
    frame.region = region_.status(frame.stop.levels);
}

}  // namespace pdr
