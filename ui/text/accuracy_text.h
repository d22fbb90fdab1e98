#pragma once
/// Sentences on the image's accuracy, on the time that more accuracy takes, and on whatever else must be known of it.

#include <QString>
#include <optional>
#include <vector>

#include "render/accuracy/stop_rule.h"
#include "render/film/error/level_error_map.h"
#include "render/film/error/shown_status.h"

namespace pdr::ui {

/// Whether and why rendering has stopped.
enum class Holding { no, paused, reached };

/// The values from which the accuracy sentence and the strip below it are made.
struct Accuracy {
    FilmStatus status;               ///< status of the image on the screen
    bool coarse = false;             ///< a better image follows soon
    ErrorOf of = ErrorOf::film;      ///< the image whose error and forecast are given
    std::vector<QualityStep> steps;  ///< empty: not known
    double seconds = 0;              ///< rendering time so far
    Holding holding = Holding::no;
    std::vector<ErrorPoint> points;              ///< measured errors over time; empty: not known
    std::optional<double> planningSeconds = {};  ///< time from the beginning until ±8 in the previous rendering
    bool box = false;                            ///< all values are those of the box on the image alone
    std::optional<FilmStatus> film = {};         ///< film's status if a denoised image is shown; none: it is `status`
};

/// Returns a duration as "8 s", "1.5 min" or "2.0 h".
QString durationText(double seconds);

/// Returns the accuracy sentence: "Good for orientation · Denoised, image error ±16 of 255 grey levels (95 % of the
/// tissue) · ±8 in 40 s": a word, the error of the image shown, and the time to the next step. It says what is not known
/// yet, and how long the previous rendering took. It begins with "In the region: ..." where it applies to the region
/// alone. Empty without samples.
QString accuracyText(const Accuracy& accuracy);

/// Returns a remark for images that leave the program: "Preview, not converged · image error ±12 of 255 grey levels
/// (95 % of the tissue), target ±1". Empty if the image is within `target` levels.
QString previewText(const ShownStatus& shown, double target);

/// Returns the noise of the film itself: "±16 levels for 95 % of the tissue; 8 % of its light", "... before denoising"
/// if a denoised image is shown; or that it is not known. Empty without samples.
QString noiseText(const Accuracy& accuracy);

/// Returns the error at one place: "This pixel ±12; mean over 1 mm ±3", and which of them is not known yet. For a
/// denoised image, whose errors are correlated from pixel to pixel, "This pixel ±6". Empty without tissue.
QString hereText(const LevelErrorsAt& errors, ErrorOf of);

/// Returns which limit ends the rendering, and what is reached by then: "±4 comes first: in 2.1 min, with 340 samples".
QString stopText(const StopRule& rule, const Accuracy& accuracy);

/// Returns a step as on the strip, "±8"; and with its forecast, "±8 in 40 s, to 95 % between 34 s and 47 s".
QString stepText(double levels);
QString stepForecastText(const QualityStep& step, double secondsNow);

}  // namespace pdr::ui
