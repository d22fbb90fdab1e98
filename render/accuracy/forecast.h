#pragma once
/// When a picture will be how good, foretold from how it has become better so far.
///   error      FilmStatus::displayError, falls as n^-b with the samples n; b is 1/2 for independent samples, more for
///              low-discrepancy points, less while rare light is still being found
///   exponent   what is known of it from other scenes whose points have gained as much (FilmStatus::gain), and what
///   this
///              picture's own errors say, weighed by how sure both are
///   interval   95 %, from the chance in the error now and then, in the exponent, and in the speed

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/film/film_status.h"

namespace pdr {

/// Display levels within which 95 % of the tissue is to lie. A screen shows nothing finer than the last.
inline constexpr std::array<double, 6> kQualitySteps{32, 16, 8, 4, 2, 1};
inline constexpr double kFinestStep = kQualitySteps.back();

/// A number that is not known yet: to 95 % it lies between two others, >= low and <= high.
struct Foretold {
    double value = 0, low = 0, high = 0;
};

/// What a picture showed.
struct ErrorPoint {
    double seconds = 0;  ///< of rendering, > 0
    double levels = 0;   ///< FilmStatus::displayError, > 0
    double spread = 0;   ///< standard deviation of that
};

/// When a step is reached.
struct QualityStep {
    double levels = 0;
    bool reached = false;
    /// Of rendering, from the picture's beginning [s]. Of a step that rests on few bright samples, `value` is `low`,
    /// and `high` is infinite: it takes at least so long.
    Foretold seconds;
    bool atLeast() const;
};

/// The last of the steps that are reached, and the first that is not; null: there is none.
const QualityStep* reachedStep(const std::vector<QualityStep>& steps);
const QualityStep* nextStep(const std::vector<QualityStep>& steps);

/// When an error of `levels`, > 0, was or will be reached, between the steps and beyond [s]; none without steps.
std::optional<Foretold> secondsAt(const std::vector<QualityStep>& steps, double levels);
/// The error after so many seconds, > 0, of rendering [levels]. There must be steps.
double levelsAt(const std::vector<QualityStep>& steps, double seconds);

/// Samples per pixel, in all, until an error that falls like most falls from `error` to `target` (> 0), whatever its
/// unit. Infinite while it is not known; the samples that are there if it is reached already.
double samplesToReach(double target, double error, std::uint64_t samples);

/// So many times the samples of picture `a` bring picture `b` to the same error, whatever that is: both have the same
/// samples per pixel. None where a displayError is not known, or is nothing.
std::optional<Foretold> samplesRatio(const FilmStatus& a, const FilmStatus& b);

class ErrorHistory {
  public:
    void clear() { *this = {}; }
    /// Other errors from now on, as on another display; the speed stays what it is.
    void forgetErrors();
    /// What a picture showed after `seconds` of rendering; samples and seconds never less than before.
    void add(double seconds, const FilmStatus& status);

    /// Of the pictures so far whose error is known, a few to each doubling of the samples, and the newest.
    std::vector<ErrorPoint> points() const;
    /// Samples per pixel, in all, until the error is `levels`, which it is not yet. One error must be known. Where few
    /// bright samples are all that is there, or none in some of the tissue: at least so many, `value` is `low` and
    /// `high` infinite.
    Foretold samples(double levels) const;
    /// Seconds of rendering, in all; errors and a speed must be known.
    Foretold seconds(double levels) const;
    /// Of all kQualitySteps, in their order, later ones never sooner; none while errors or the speed are not known.
    std::vector<QualityStep> steps() const;

  private:
    struct Point {
        double samples = 0, seconds = 0;
        double error = 0;      ///< not finite: not known
        double spread = 0;     ///< of its logarithm
        double chance = 0;     ///< standard deviation that chance gives it
        double gain = 0;       ///< of points over independent samples; 0: not known
        bool isBound = false;  ///< the error is one that may still grow, or fall as no other does
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
    /// Of the speed's logarithm [samples/s].
    Guess speed() const;
    bool foresees() const;
    bool restedOnBound() const;

    std::vector<Point> points_;  ///< a few to each doubling of the samples, and the newest
    std::array<std::optional<double>, kQualitySteps.size()> reachedAt_;  ///< [s]; none: the newest error is above
};

}  // namespace pdr
