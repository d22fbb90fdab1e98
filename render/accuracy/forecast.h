#pragma once
/// Forecasts when an image reaches which quality, from how it has improved so far.
///   error      FilmStatus::displayError, falls as n^-b with the samples n; b is 1/2 for independent samples, more for
///              low-discrepancy points, less while rare light is still being found
///   exponent   b, from other scenes whose points have gained as much (FilmStatus::gain) and from the errors of this
///              image, weighted by how certain both are
///   interval   95 %, from chance in the error now and then, in the exponent, and in the speed

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/film/film_status.h"

namespace pdr {

/// Display levels within which 95 % of the tissue is to lie. A screen shows nothing finer than the last one.
inline constexpr std::array<double, 6> kQualitySteps{32, 16, 8, 4, 2, 1};
inline constexpr double kFinestStep = kQualitySteps.back();

/// A forecast value and its 95 % interval, with low <= value <= high.
struct Foretold {
    double value = 0, low = 0, high = 0;
};

/// Error of an image at one time.
struct ErrorPoint {
    double seconds = 0;  ///< rendering time, > 0
    double levels = 0;   ///< FilmStatus::displayError, > 0
    double spread = 0;   ///< standard deviation of `levels`
};

/// A step of quality, and when it is reached.
struct QualityStep {
    double levels = 0;
    bool reached = false;
    /// Rendering time from the image's beginning [s]. If the step rests on few bright samples, `value` is `low` and
    /// `high` is infinite: it takes at least so long.
    Foretold seconds;
    bool atLeast() const;
};

/// Returns the last step that is reached; nextStep(): the first one that is not. Null if there is none.
const QualityStep* reachedStep(const std::vector<QualityStep>& steps);
const QualityStep* nextStep(const std::vector<QualityStep>& steps);

/// Returns when an error of `levels`, > 0, was or will be reached [s], between the steps and beyond; none without
/// steps.
std::optional<Foretold> secondsAt(const std::vector<QualityStep>& steps, double levels);
/// Returns the error after so many seconds, > 0, of rendering [levels]. There must be steps.
double levelsAt(const std::vector<QualityStep>& steps, double seconds);

/// Returns the total samples per pixel at which an error that falls like most errors decreases from `error` to `target`
/// (> 0), in any unit. Infinite while the error is not known; `samples` if the target is reached already.
double samplesToReach(double target, double error, std::uint64_t samples);

/// Returns the ratio of the samples that image `b` needs to those that image `a` needs for the same error,
/// whatever that is; both have the same samples per pixel. None if a displayError is not known or is 0.
std::optional<Foretold> samplesRatio(const FilmStatus& a, const FilmStatus& b);

class ErrorHistory {
  public:
    void clear() { *this = {}; }
    /// Forgets the errors, as for another display; the speed stays what it is.
    void forgetErrors();
    /// Adds what an image showed after `seconds` of rendering; samples and seconds must never decrease.
    void add(double seconds, const FilmStatus& status);

    /// Returns the points of the images so far whose error is known: a few for each doubling of the samples, and the
    /// newest.
    std::vector<ErrorPoint> points() const;
    /// Returns the total samples per pixel until the error is `levels`, which it is not yet. One error must be known.
    /// If there are only few bright samples, or none in some of the tissue, the result is a lower bound: `value` is
    /// `low` and `high` is infinite.
    Foretold samples(double levels) const;
    /// Returns the total rendering time until the error is `levels` [s]; errors and a speed must be known.
    Foretold seconds(double levels) const;
    /// Returns all kQualitySteps in their order, later ones never sooner; none while errors or the speed are not known.
    std::vector<QualityStep> steps() const;

  private:
    struct Point {
        double samples = 0, seconds = 0;
        double error = 0;      ///< displayError; not finite if not known
        double spread = 0;     ///< standard deviation of the error's logarithm
        double chance = 0;     ///< standard deviation of the error by chance
        double gain = 0;       ///< gain of points over independent samples; 0: not known
        bool isBound = false;  ///< the error is a bound: it may still grow, or fall in an unusual way
    };
    struct Guess {
        double mean, variance;
    };

    Guess exponentOfOthers() const;
    Guess exponent() const;
    struct Recent {
        double logError, squaredSpread;
    };
    Recent recent(double exponent) const;
    /// Returns mean and variance of the speed's logarithm [samples/s].
    Guess speed() const;
    bool foresees() const;
    bool restedOnBound() const;

    std::vector<Point> points_;  ///< a few to each doubling of the samples, and the newest
    std::array<std::optional<double>, kQualitySteps.size()> reachedAt_;  ///< [s]; none: the newest error is above
};

}  // namespace pdr
