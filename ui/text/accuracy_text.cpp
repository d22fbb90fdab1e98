#include "ui/text/accuracy_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "render/accuracy/quality.h"
#include "render/film/levels_text.h"
#include "ui/text/language.h"

namespace pdr::ui {
namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("accuracyText", text);
}

QString wordText(Quality quality) {
    switch (quality) {
        case Quality::estimating:
            return translated("Estimating");
        case Quality::rough:
            return translated("Rough");
        case Quality::orientation:
            return translated("Good for orientation");
        case Quality::planning:
            return translated("Good for planning");
        case Quality::reference:
            break;
    }
    return translated("Reference");
}

QString levels(double value) {
    return localNumber(levelsText(value));
}

/// Appends the time of the previous rendering, as long as there is no forecast for this image.
QString withLastTime(const QString& sentence, const Accuracy& accuracy) {
    if (!accuracy.planningSeconds)
        return sentence;
    return translated("%1 · ±%2 took %3 the last time")
        .arg(sentence, levels(kPlanningLevels), durationText(*accuracy.planningSeconds));
}

QString unknownText(const Accuracy& accuracy) {
    const FilmStatus& status = accuracy.status;
    if (status.samplesPerPixel < kSamplesToEstimate)
        return withLastTime(translated("Estimating how good the image is"), accuracy);
    if (status.unseenShare > 0)
        return translated("Estimating · image still black");
    return std::isfinite(status.relativeError) ? translated("No tissue is in view")
                                               : translated("Estimating · the error is not known yet");
}

/// What the end of the sentence says.
enum class Ending { none, price, leastPrice, paused, reached };

Ending endingOf(Holding holding, const QualityStep* next) {
    if (holding != Holding::no)
        return holding == Holding::paused ? Ending::paused : Ending::reached;
    if (next == nullptr)
        return Ending::none;
    return next->atLeast() ? Ending::leastPrice : Ending::price;
}

/// Returns the error, and which image it belongs to.
QString numberText(const Accuracy& accuracy) {
    const QString within = levels(accuracy.status.displayError);
    switch (accuracy.of) {
        case ErrorOf::denoised:
            return translated("Denoised, image error ±%1 of 255 grey levels (95 % of the tissue)").arg(within);
        case ErrorOf::beforeDenoising:
            return translated("Image error ±%1 of 255 grey levels before denoising (95 % of the tissue)").arg(within);
        case ErrorOf::film:
            break;
    }
    return translated("Image error ±%1 of 255 grey levels (95 % of the tissue)").arg(within);
}

/// Returns the time to the next step, or why rendering has stopped. `next`: the next step, for a forecast.
QString endingText(Ending ending, const QualityStep* next, const Accuracy& accuracy) {
    const auto priced = [&](const QString& text) {
        return text.arg(levels(next->levels), durationText(next->seconds.value - accuracy.seconds));
    };
    switch (ending) {
        case Ending::price:
            return priced(translated("±%1 in %2"));
        case Ending::leastPrice:
            return priced(translated("±%1 in at least %2"));
        case Ending::paused:
            return translated("paused");
        case Ending::reached:
            return translated("target reached (Space: continue)");
        case Ending::none:
            break;
    }
    return {};
}

QString previewSentence(ErrorOf of) {
    switch (of) {
        case ErrorOf::denoised:
            return translated(
                "Preview, not converged · denoised, image error ±%1 of 255 grey levels (95 % of the tissue), target "
                "±%2");
        case ErrorOf::beforeDenoising:
            return translated(
                "Preview, not converged · image error ±%1 of 255 grey levels before denoising (95 % of the tissue), "
                "target ±%2");
        case ErrorOf::film:
            break;
    }
    return translated("Preview, not converged · image error ±%1 of 255 grey levels (95 % of the tissue), target ±%2");
}

/// Returns the accuracy sentence without the prefix for the box.
QString sentenceOn(const Accuracy& accuracy) {
    const FilmStatus& status = accuracy.status;
    if (accuracy.coarse)
        return withLastTime(translated("Coarse preview; the full image follows"), accuracy);
    if (!std::isfinite(status.displayError))
        return accuracy.holding == Holding::paused ? translated("%1 · paused").arg(unknownText(accuracy))
                                                   : unknownText(accuracy);
    const QualityStep* next = nextStep(accuracy.steps);
    QStringList parts{wordText(qualityOf(status)), numberText(accuracy),
                      endingText(endingOf(accuracy.holding, next), next, accuracy)};
    parts.removeAll({});
    return parts.join(QString::fromUtf8(" · "));
}

}  // namespace

QString durationText(double seconds) {
    if (seconds < 60)
        return translated("%1 s").arg(std::max(1.0, std::round(seconds)));
    const bool hours = seconds >= 3600;
    const double value = seconds / (hours ? 3600 : 60);
    return (hours ? translated("%1 h") : translated("%1 min")).arg(number(value, value < 10 ? 1 : 0));
}

QString accuracyText(const Accuracy& accuracy) {
    if (accuracy.status.samplesPerPixel == 0)
        return {};
    const QString sentence = sentenceOn(accuracy);
    return accuracy.box ? translated("In the region: %1").arg(sentence) : sentence;
}

QString previewText(const ShownStatus& shown, double target) {
    const double off = shown.status.displayError;
    if (off <= target)
        return {};
    if (!std::isfinite(off))
        return translated("Preview, not converged · error not known yet");
    return previewSentence(shown.of).arg(levels(off), levels(target));
}

QString noiseText(const Accuracy& accuracy) {
    const FilmStatus& status = accuracy.film ? *accuracy.film : accuracy.status;
    if (status.samplesPerPixel == 0)
        return {};
    if (!std::isfinite(status.displayError) || !std::isfinite(status.relativeError))
        return translated("not known yet");
    return translated(accuracy.film ? "±%1 levels for 95 % of the tissue before denoising; %2 % of its light"
                                    : "±%1 levels for 95 % of the tissue; %2 % of its light")
        .arg(levels(status.displayError))
        .arg(std::ceil(100 * status.relativeError));
}

QString hereText(const LevelErrorsAt& errors, ErrorOf of) {
    if (!errors.tissue)
        return {};
    if (!std::isfinite(errors.here))
        return translated("This pixel: not known yet");
    const QString here = levels(double(errors.here));
    if (of == ErrorOf::denoised)
        return translated("This pixel ±%1").arg(here);
    QString text = translated("This pixel ±%1; mean over 1 mm not known yet").arg(here);
    if (errors.side < 1)
        text = translated("This pixel ±%1; it is larger than 1 mm").arg(here);
    else if (std::isfinite(errors.over))
        text = translated("This pixel ±%1; mean over 1 mm ±%2").arg(here, levels(double(errors.over)));
    return of == ErrorOf::beforeDenoising ? translated("%1, before denoising").arg(text) : text;
}

QString stopText(const StopRule& rule, const Accuracy& accuracy) {
    const std::optional<ForetoldStop> stop =
        foretoldStop(rule, accuracy.steps, accuracy.seconds, accuracy.status.samplesPerPixel);
    if (!stop)
        return translated("which of them comes first is not known yet");
    const QString by = levels(stop->levels), samples = number(std::ceil(stop->samples), 0);
    const QString left = durationText(std::max(stop->seconds - accuracy.seconds, 0.0));
    if (accuracy.holding == Holding::reached)
        return translated("stopped after %1, with %2 samples")
            .arg(durationText(accuracy.seconds))
            .arg(accuracy.status.samplesPerPixel);
    switch (stop->cause) {
        case ForetoldStop::Cause::levels:
            return translated("±%1 comes first: in %2, with %3 samples").arg(by, left, samples);
        case ForetoldStop::Cause::seconds:
            return translated("the time comes first: in %2, within ±%1 and with %3 samples").arg(by, left, samples);
        case ForetoldStop::Cause::samples:
            break;
    }
    return translated("the samples come first: %3 in %2, within ±%1").arg(by, left, samples);
}

QString stepText(double stepLevels) {
    return translated("±%1").arg(levels(stepLevels));
}

QString stepForecastText(const QualityStep& step, double secondsNow) {
    const auto left = [&](double seconds) { return durationText(std::max(seconds - secondsNow, 0.0)); };
    if (step.reached)
        return translated("±%1 since %2 of rendering").arg(levels(step.levels), durationText(step.seconds.value));
    if (step.atLeast())
        return translated("±%1 in at least %2").arg(levels(step.levels), left(step.seconds.value));
    return translated("±%1 in %2, to 95 % between %3 and %4")
        .arg(levels(step.levels), left(step.seconds.value), left(step.seconds.low), left(step.seconds.high));
}

}  // namespace pdr::ui
