#include "render/accuracy/forecast.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pdr {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();
constexpr double kSigmas = 1.96;  ///< from the mean to either end of 95 % of a normal distribution

/// Exponent of most scenes with low-discrepancy points, and the deviation of single scenes from it: see
/// tests/support/scenes/coverage_scenes.h and DECISIONS.md.
constexpr double kExponent = 0.57, kExponentSpread = 0.07;
/// The known gain of points over independent samples says more. So far, errors fell as n^-a on average, with
/// a = 1/2 + ln gain / ln n. Errors with a = kUsualFall go on as n^-kUsualExponent. A difference from
/// kUsualFall grows by the factor kGoesOn from now on, because a includes the gain of the first samples.
constexpr double kUsualFall = 0.62, kUsualExponent = 0.59, kGoesOn = 1.35, kExponentOfGainSpread = 0.03;
constexpr double kLeastExponent = 0.5, kMostExponent = 0.8;  ///< at least that of independent samples
/// Deviation of the exponent in one doubling of the samples from that of the scene.
constexpr double kExponentWander = 0.07;
/// Low-discrepancy points dip below the line at powers of two, by a twentieth. So the current error is the mean over
/// all errors since the samples were kRecent times fewer; kDip is what is left of the dip, in the error's logarithm.
constexpr double kRecent = 2, kDip = 0.04;
/// Least spread of the speed's logarithm: other work of the machine changes it by so much.
constexpr double kSpeedSpread = 0.05;

/// Factor of the samples up to which earlier errors count: before, they fell otherwise, because a display clips large
/// ones.
constexpr double kWatched = 16;
constexpr double kLasting = 8;      ///< growth of the samples for which a bound still counts
constexpr double kThinning = 1.09;  ///< 2^(1/8): least ratio of the samples of two points that are kept

double squared(double value) {
    return value * value;
}

/// Returns the spread of the logarithm of a displayError.
double spreadOf(const FilmStatus& status) {
    return std::hypot(kDip, status.displayError > 0 ? status.displayErrorSpread / status.displayError : 0);
}

}  // namespace

double samplesToReach(double target, double error, std::uint64_t samples) {
    return double(samples) * std::max(std::pow(error / target, 1 / kExponent), 1.0);
}

/// The uncertainty of the exponent does not cancel although both share it: it multiplies the difference of the
/// logarithms.
std::optional<Foretold> samplesRatio(const FilmStatus& a, const FilmStatus& b) {
    const bool known = std::isfinite(a.displayError) && std::isfinite(b.displayError);
    if (!known || !(a.displayError > 0) || !(b.displayError > 0))
        return std::nullopt;
    const double growth = std::log(b.displayError / a.displayError) / kExponent;
    const double spread = kSigmas * std::hypot(growth * kExponentSpread, spreadOf(a), spreadOf(b)) / kExponent;
    return Foretold{std::exp(growth), std::exp(growth - spread), std::exp(growth + spread)};
}

void ErrorHistory::forgetErrors() {
    for (Point& point : points_)
        point.error = kUnknown;
    reachedAt_ = {};
}

void ErrorHistory::add(double seconds, const FilmStatus& status) {
    const Point point{double(status.samplesPerPixel),
                      seconds,
                      status.displayError,
                      spreadOf(status),
                      status.displayErrorSpread,
                      status.gain,
                      status.fewBrightSamples || status.unlitTissue};
    const std::size_t kept = points_.size();
    if (kept > 1 && points_[kept - 1].samples < kThinning * points_[kept - 2].samples)
        points_.pop_back();
    points_.push_back(point);
    for (std::size_t i = 0; i < kQualitySteps.size(); ++i)
        if (!(status.displayError <= kQualitySteps[i]))
            reachedAt_[i].reset();
        else if (!reachedAt_[i])
            reachedAt_[i] = seconds;
}

/// Returns the exponent of other scenes whose points have recently gained as much as these.
ErrorHistory::Guess ErrorHistory::exponentOfOthers() const {
    double falls = 0, count = 0;
    for (auto point = points_.rbegin(); point != points_.rend() && kRecent * point->samples >= points_.back().samples;
         ++point)
        if (point->gain > 0 && point->samples > 1) {
            falls += 0.5 + std::log(point->gain) / std::log(point->samples);
            ++count;
        }
    if (count == 0)
        return {kExponent, squared(kExponentSpread)};
    const double goesOn = kUsualExponent + kGoesOn * (falls / count - kUsualFall);
    return {std::clamp(goesOn, kLeastExponent, kMostExponent), squared(kExponentOfGainSpread)};
}

/// Returns the exponent of the line between the errors at both ends of the watched range, weighted against that of
/// other scenes. Both errors are uncertain, and the exponent varies from doubling to doubling.
ErrorHistory::Guess ErrorHistory::exponent() const {
    const Point& now = points_.back();
    const auto first = std::find_if(points_.begin(), points_.end(), [&](const Point& point) {
        return std::isfinite(point.error) && kWatched * point.samples >= now.samples;
    });
    const double doublings = std::log2(now.samples / first->samples);
    const Guess others = exponentOfOthers();
    if (!(doublings >= 1) || !(now.error > 0))
        return others;
    const double length = std::log(now.samples / first->samples);
    const Recent recent = this->recent(others.mean);
    const double own = (std::log(first->error) - recent.logError) / length;
    const double ownVariance =
        (squared(first->spread) + recent.squaredSpread) / squared(length) + squared(kExponentWander) / doublings;
    const double weight = others.variance / (others.variance + ownVariance);
    return {std::lerp(others.mean, own, weight), weight * ownVariance};
}

/// Returns the current error of the image and its spread, as means over recent ones, because few pixels determine
/// either.
ErrorHistory::Recent ErrorHistory::recent(double exponent) const {
    const Point& now = points_.back();
    double errors = 0, spreads = 0, count = 0;
    for (auto point = points_.rbegin(); point != points_.rend() && kRecent * point->samples >= now.samples; ++point)
        if (std::isfinite(point->error) && point->error > 0) {
            errors += std::log(point->error) - exponent * std::log(now.samples / point->samples);
            spreads += squared(point->spread);
            ++count;
        }
    return {errors / count, spreads / count};
}

/// Returns whether an error was a bound now, or so recently that the errors from which the forecast begins may be too
/// small.
bool ErrorHistory::restedOnBound() const {
    return std::ranges::any_of(points_, [&](const Point& point) {
        return point.isBound && kLasting * point.samples > points_.back().samples;
    });
}

/// Pixels whose error is large now are likely to have a large one when the samples have grown but little. The
/// error that is stated for pixels without any bright sample falls as 1 / n at most.
Foretold ErrorHistory::samples(double levels) const {
    const Point& now = points_.back();
    const Guess exponent = this->exponent();
    const Recent recent = this->recent(exponent.mean);
    const double fall = std::max(recent.logError - std::log(levels), 0.0), growth = fall / exponent.mean;
    const double chance = 2 * recent.squaredSpread * -std::expm1(-growth);
    const double wander = squared(kExponentWander) * growth * std::log(2.0);
    const double spread = kSigmas * std::sqrt(chance + squared(growth) * exponent.variance + wander) / exponent.mean;
    const auto after = [&](double more) { return now.samples * std::exp(std::max(more, 0.0)); };
    if (restedOnBound()) {
        const double least = after(std::min(growth - spread, fall - kSigmas * std::sqrt(chance)));
        return {least, least, kUnknown};
    }
    return {after(growth), after(growth - spread), after(growth + spread)};
}

/// Returns the speed over the last doubling of the samples, and its variation.
ErrorHistory::Guess ErrorHistory::speed() const {
    const Point& now = points_.back();
    std::size_t first = points_.size() - 1;
    while (first > 0 && points_[first - 1].samples > 0.5 * now.samples)
        --first;
    first = first > 0 ? first - 1 : 0;
    const double mean = std::log((now.samples - points_[first].samples) / (now.seconds - points_[first].seconds));
    double squares = 0, pieces = 0;
    for (std::size_t i = first + 1; i < points_.size(); ++i)
        if (const Point& from = points_[i - 1], &to = points_[i];
            to.samples > from.samples && to.seconds > from.seconds) {
            squares += squared(std::log((to.samples - from.samples) / (to.seconds - from.seconds)) - mean);
            ++pieces;
        }
    return {mean, squared(kSpeedSpread) + (pieces > 0 ? squares / pieces : 0)};
}

/// Counts time from now on. The uncertainties of the samples and of the speed add up in squares.
Foretold ErrorHistory::seconds(double levels) const {
    const Point& now = points_.back();
    const Foretold samples = this->samples(levels);
    const Guess speed = this->speed();
    const auto left = [&](double wanted) { return (wanted - now.samples) * std::exp(-speed.mean); };
    const double value = left(samples.value), slower = std::exp(kSigmas * std::sqrt(speed.variance));
    const double sooner = std::hypot(value - left(samples.low), value - value / slower);
    const double low = now.seconds + std::max(value - sooner, 0.0);
    if (std::isinf(samples.high))
        return {low, low, kUnknown};
    const double later = std::hypot(left(samples.high) - value, value * slower - value);
    return {now.seconds + value, low, now.seconds + value + later};
}

std::vector<ErrorPoint> ErrorHistory::points() const {
    std::vector<ErrorPoint> known;
    for (const Point& point : points_)
        if (std::isfinite(point.error) && point.error > 0 && point.seconds > 0)
            known.push_back({point.seconds, point.error, point.chance});
    return known;
}

bool ErrorHistory::foresees() const {
    return points_.size() > 1 && std::isfinite(points_.back().error) &&
           points_.back().samples > points_.front().samples && points_.back().seconds > points_.front().seconds;
}

std::vector<QualityStep> ErrorHistory::steps() const {
    std::vector<QualityStep> steps;
    if (!foresees())
        return steps;
    for (std::size_t i = 0; i < kQualitySteps.size(); ++i) {
        QualityStep step{kQualitySteps[i], reachedAt_[i].has_value()};
        step.seconds = step.reached ? Foretold{*reachedAt_[i], *reachedAt_[i], *reachedAt_[i]} : seconds(step.levels);
        steps.push_back(step);
    }
    return steps;
}

}  // namespace pdr
