#pragma once
/// How good the picture is, what more would cost, and what else is to be known of it, in whole sentences.

#include <QString>
#include <optional>
#include <vector>

#include "render/accuracy/stop_rule.h"
#include "render/film/error/level_error_map.h"
#include "render/film/error/shown_status.h"

namespace pdr::ui {

/// Why rendering holds, if it does.
enum class Holding { no, paused, reached };

/// All that the sentence and the strip below it are made from.
struct Accuracy {
    FilmStatus status;               ///< of what is shown
    bool coarse = false;             ///< a better picture follows soon
    ErrorOf of = ErrorOf::film;      ///< image that the error and all that is foretold of it speak of
    std::vector<QualityStep> steps;  ///< none: not known
    double seconds = 0;              ///< of rendering so far
    Holding holding = Holding::no;
    std::vector<ErrorPoint> points;              ///< how the error has fallen; none: not known
    std::optional<double> planningSeconds = {};  ///< from the beginning until +-8, as it took the last time
    bool box = false;                            ///< all of this is said of the box on the picture alone
    std::optional<FilmStatus> film = {};         ///< where a denoised image is shown; none: `status` is the film's
};

/// "8 s", "1.5 min", "2.0 h"
QString durationText(double seconds);

/// "Good for orientation · denoised: 95 % of the tissue within ±16 of 255 grey levels · ±8 in 40 s": a word, the number
/// of what is seen, the price of the next step. What is not known it says, and what it was the last time. "In the box:
/// ..." where it is said of that alone. Nothing without samples.
QString accuracyText(const Accuracy& accuracy);

/// "Preview, not converged · 95 % of the tissue within ±12 of 255 grey levels, wanted ±1", for pictures that leave the
/// window; nothing where it is as good as was wanted.
QString previewText(const ShownStatus& shown, double target);

/// Noise of the film itself: "±16 levels for 95 % of the tissue; 8 % of its light", "... before denoising" where it is
/// shown denoised; or that it is not known. Nothing without samples.
QString noiseText(const Accuracy& accuracy);

/// At one place: "here ±12; over 1 mm ±3", and what of that is not known yet; of a denoised image, whose pixels err
/// together, "here ±6". Nothing without tissue.
QString hereText(const LevelErrorsAt& errors, ErrorOf of);

/// Which limit ends the rendering, and what is there by then: "±4 comes first: in 2.1 min, with 340 samples".
QString stopText(const StopRule& rule, const Accuracy& accuracy);

/// A step on the strip: "±8"; and for a reader: "±8 in 40 s, to 95 % between 34 s and 47 s".
QString stepText(double levels);
QString stepForecastText(const QualityStep& step, double secondsNow);

}  // namespace pdr::ui
