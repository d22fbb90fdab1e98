/// Forecasts of an image's error, from given errors and times.

#include <QTest>
#include <cmath>

#include "render/accuracy/stop_rule.h"

using namespace pdr;

namespace {

/// Images of 32, 64, ... samples up to `last` whose error falls as n^-exponent from 40 levels, at `speed` samples per
/// second.
struct Fall {
    double exponent = 0.57, spread = 0.001, speed = 10;

    double errorOf(double samples) const { return 40 * std::pow(samples / 32, -exponent); }
    /// Returns the samples at which the error is `levels`.
    double samplesOf(double levels) const { return 32 * std::pow(40 / levels, 1 / exponent); }
    FilmStatus status(std::uint64_t samples) const {
        const double error = errorOf(double(samples));
        return {.samplesPerPixel = samples, .displayError = error, .displayErrorSpread = spread * error};
    }
    ErrorHistory until(std::uint64_t last) const {
        ErrorHistory history;
        for (std::uint64_t n = 32; n <= last; n *= 2)
            history.add(double(n) / speed, status(n));
        return history;
    }
};

bool contains(const Foretold& foretold, double truth) {
    return foretold.low <= truth && truth <= foretold.high;
}

double width(const Foretold& foretold) {
    return foretold.high - foretold.low;
}

}  // namespace

class ForecastTest : public QObject {
    Q_OBJECT

  private slots:
    void whatWasShownIsKeptAsFarAsItIsKnown() {
        ErrorHistory history;
        history.add(1, {.samplesPerPixel = 16});
        const Fall fall;
        for (const std::uint64_t n : {32, 64, 65})
            history.add(double(n) / 8, fall.status(n));
        const std::vector<ErrorPoint> points = history.points();
        QCOMPARE(points.size(), std::size_t(3));
        QVERIFY(points[0].seconds == 4 && points[1].seconds == 8 && points[2].seconds == 65.0 / 8);
        QCOMPARE(points[1].levels, fall.errorOf(64));
        QCOMPARE(points[1].spread, fall.spread * fall.errorOf(64));
        history.forgetErrors();
        QVERIFY(history.points().empty());
    }

    void errorsThatFallAsMostDoAreForetoldExactly() {
        const Fall fall;
        const std::vector<QualityStep> steps = fall.until(256).steps();
        QCOMPARE(steps.size(), kQualitySteps.size());
        for (const QualityStep& step : steps) {
            const double truth = fall.samplesOf(step.levels) / fall.speed;
            QCOMPARE(step.reached, step.levels > fall.errorOf(256));
            if (step.reached)
                QVERIFY(step.seconds.value >= truth && step.seconds.low == step.seconds.high);
            else
                QVERIFY(std::fabs(step.seconds.value / truth - 1) < 1e-9 && contains(step.seconds, truth));
        }
        QVERIFY(reachedStep(steps)->levels == 16 && nextStep(steps)->levels == 8);
    }

    /// Errors fall as in most scenes: 2^(1/0.57) times the samples. An error that is unknown or 0 has no ratio.
    void twiceTheErrorTakesMoreThanThreeTimesTheSamples() {
        const FilmStatus one{.samplesPerPixel = 64, .displayError = 8, .displayErrorSpread = 0.1};
        const FilmStatus two{.samplesPerPixel = 64, .displayError = 16, .displayErrorSpread = 0.1};
        const Foretold ratio = *samplesRatio(one, two), back = *samplesRatio(two, one), same = *samplesRatio(one, one);
        QVERIFY(std::fabs(ratio.value - std::pow(2, 1 / 0.57)) < 1e-9 &&
                std::fabs(ratio.value * back.value - 1) < 1e-9);
        QVERIFY(contains(ratio, 3) && contains(ratio, 4) && !contains(ratio, 1));
        QVERIFY(same.value == 1 && contains(same, 1.1) && contains(same, 0.9));
        QVERIFY(!samplesRatio(one, FilmStatus{}) && !samplesRatio(FilmStatus{.displayError = 0}, one));
    }

    /// In an unusual scene, the longer its errors are observed, the less the exponent of other scenes counts.
    void theExponentIsLearnedFromTheImage() {
        const Fall slow{.exponent = 0.45};
        double before = INFINITY;
        for (const std::uint64_t n : {32, 256, 4096}) {
            const Foretold samples = slow.until(n).samples(slow.errorOf(double(4 * n)));
            const double off = std::fabs(std::log(samples.value / (4.0 * double(n))));
            QVERIFY(contains(samples, 4 * double(n)) && off < before);
            before = off;
        }
        QVERIFY(before < 0.15);
    }

    /// Errors of points that have gained 1.73 over independent samples in 64 fall as n^-0.61 from there; without any
    /// gain, as those of independent samples.
    void pointsThatHaveGainedMuchAreForetoldToGoOnFaster() {
        const auto foretold = [](double gain) {
            FilmStatus status = Fall().status(64);
            status.gain = gain;
            ErrorHistory history;
            history.add(6.4, status);
            return history.samples(status.displayError / 2).value;
        };
        QVERIFY(std::fabs(foretold(1.73) / (64 * std::pow(2, 1 / 0.606)) - 1) < 0.01);
        QVERIFY(std::fabs(foretold(0) / (64 * std::pow(2, 1 / 0.57)) - 1) < 1e-9);
        QVERIFY(std::fabs(foretold(1) / (64 * std::pow(2, 1 / 0.5)) - 1) < 1e-9);
        QVERIFY(foretold(4) < foretold(2) && foretold(2) < foretold(1.73));
    }

    void whatIsStatedOfTissueWithoutLightIsALowerBound() {
        FilmStatus status = Fall().status(64);
        status.unlitTissue = true;
        ErrorHistory history;
        history.add(6.4, status);
        const Foretold samples = history.samples(status.displayError / 2);
        QVERIFY(std::isinf(samples.high) && samples.value == samples.low && samples.low <= 128);
    }

    void whatIsLessSureHasTheWiderInterval() {
        const Fall sure, noisy{.spread = 0.1};
        QVERIFY(width(noisy.until(256).samples(4)) > 1.2 * width(sure.until(256).samples(4)));
        QVERIFY(width(sure.until(256).samples(4)) > width(sure.until(256).samples(8)));
        ErrorHistory unsteady;
        double seconds = 0;
        for (std::uint64_t n = 32; n <= 256; n = n * 5 / 4) {
            seconds += double(n) / 5 / (n % 2 == 0 ? 5 : 20);
            unsteady.add(seconds, sure.status(n));
        }
        const Foretold steady = sure.until(256).seconds(8), shaky = unsteady.seconds(8);
        QVERIFY(width(shaky) / shaky.value > 1.3 * width(steady) / steady.value);
    }

    void theSpeedIsThatOfNow() {
        const Fall fall;
        ErrorHistory history = fall.until(256);
        for (int i = 1; i <= 64; ++i)  // ten times slower since
            history.add(25.6 + 4.0 * i, fall.status(256 + std::uint64_t(4 * i)));
        for (int i = 1; i <= 64; ++i)
            history.add(25.6 + 4.0 * 64 + 8.0 * i, fall.status(512 + std::uint64_t(8 * i)));
        const double truth = 25.6 + 4.0 * 64 + 8.0 * 64 + fall.samplesOf(4) - 1024;
        QVERIFY(fall.errorOf(1024) > 4);
        QVERIFY(std::fabs(history.seconds(4).value / truth - 1) < 1e-9);
    }

    void aLaterStepIsNeverForetoldSooner() {
        for (const double spread : {0.001, 0.3})
            for (const std::uint64_t n : {64, 1024, 32768}) {
                const std::vector<QualityStep> steps = Fall{.spread = spread}.until(n).steps();
                for (std::size_t i = 1; i < steps.size(); ++i)
                    QVERIFY(steps[i].seconds.value >= steps[i - 1].seconds.value);
            }
    }

    void aStepIsReachedWhenTheErrorIsAndNotLonger() {
        ErrorHistory history = Fall{}.until(128);
        QVERIFY(history.steps()[0].reached && !history.steps()[1].reached);
        QCOMPARE(history.steps()[0].seconds.value, 6.4);
        FilmStatus worse = Fall{}.status(160);
        worse.displayError = 33;
        history.add(16, worse);
        QVERIFY(!history.steps()[0].reached && reachedStep(history.steps()) == nullptr);
        worse.displayError = 0;
        history.add(17, worse);
        QVERIFY(nextStep(history.steps()) == nullptr);
    }

    void whatRestsOnFewBrightSamplesIsALowerBound() {
        const Fall fall;
        ErrorHistory history = fall.until(128);
        const Foretold whole = history.seconds(8);
        QVERIFY(whole.low < whole.value && whole.value < whole.high);
        FilmStatus rare = fall.status(128);
        rare.fewBrightSamples = true;
        history.add(12.8, rare);
        const QualityStep step = history.steps()[2];
        QVERIFY(step.atLeast() && step.seconds.value == step.seconds.low && std::isinf(step.seconds.high));
        QVERIFY(step.seconds.value <= whole.value);
        QVERIFY(!history.steps()[0].atLeast());  // this step is reached
    }

    /// Low-discrepancy points dip at powers of two: the forecast does not start from the dip alone.
    void aDipOfTheNewestErrorHardlyShowsInTheForecast() {
        const Fall fall;
        const auto until = [&](double newest) {
            ErrorHistory history;
            for (double n = 32; n <= 257; n *= std::pow(2, 0.125)) {
                FilmStatus status = fall.status(std::uint64_t(n));
                status.displayError *= n > 250 ? newest : 1;
                history.add(n / fall.speed, status);
            }
            return history.samples(6);
        };
        const double plain = until(1).value, dipped = until(0.9).value;
        QVERIFY(contains(until(1), fall.samplesOf(6)));
        QVERIFY(dipped < plain && std::log(plain / dipped) < 0.6 * std::log(1 / 0.9) / 0.57);
        ErrorHistory bump = fall.until(256);
        FilmStatus high = fall.status(272);
        high.displayError *= 1.2;
        bump.add(27.2, high);
        const Foretold soon = bump.samples(0.99 * high.displayError);  // it was reached already
        QVERIFY(soon.low >= 272 && soon.value >= soon.low && soon.high >= soon.value);
    }

    /// Errors that were stated while there were only few bright samples were too small.
    void whatRestedOnFewBrightSamplesLatelyIsStillALowerBound() {
        const Fall fall;
        ErrorHistory history = fall.until(64);
        FilmStatus rare = fall.status(128);
        rare.fewBrightSamples = true;
        history.add(12.8, rare);
        history.add(25.6, fall.status(256));
        QVERIFY(history.steps()[2].atLeast());
        history.add(51.2, fall.status(512));
        QVERIFY(history.steps()[3].atLeast());
        history.add(102.4, fall.status(1024));
        QVERIFY(!history.steps()[4].atLeast());
    }

    void nothingIsForetoldWithoutAnErrorOrWithoutSpeed() {
        ErrorHistory history;
        QVERIFY(history.steps().empty());
        history.add(1, {.samplesPerPixel = 31});
        history.add(2, {.samplesPerPixel = 62});
        QVERIFY(history.steps().empty());
        history.add(3, Fall{}.status(64));
        QVERIFY(!history.steps().empty());
        history.clear();
        history.add(3, Fall{}.status(64));
        QVERIFY(history.steps().empty());  // no speed
        history.add(3, Fall{}.status(65));
        QVERIFY(history.steps().empty());  // no time: no speed
    }

    void anotherDisplayHasOtherErrorsAndTheSameSpeed() {
        ErrorHistory history = Fall{.exponent = 0.8}.until(1024);
        history.forgetErrors();
        QVERIFY(history.steps().empty());
        FilmStatus brighter = Fall{}.status(1100);
        brighter.displayError = 24;
        history.add(110, brighter);
        QVERIFY(history.steps()[0].reached && history.steps()[0].seconds.value == 110);
        QVERIFY(std::fabs(history.seconds(12).value - history.samples(12).value / 10) < 1e-9);
        QVERIFY(std::fabs(history.samples(12).value - 1100 * std::pow(2, 1 / 0.57)) < 1e-6);
    }

    void samplesToAnErrorOfAnyUnit() {
        QCOMPARE(samplesToReach(0.3, 0.2, 100), 100.0);
        QVERIFY(std::isinf(samplesToReach(0.1, INFINITY, 2)));
        const double half = samplesToReach(0.1, 0.2, 100);
        QVERIFY(half > 300 && half < 400);  // low-discrepancy points: less than four times as many
        QVERIFY(std::fabs(samplesToReach(0.05, 0.2, 100) / half - half / 100) < 1e-9);
    }
    void betweenTwoStepsTimesLieOnALineOfLogarithms() {
        std::vector<QualityStep> steps;
        for (const double levels : kQualitySteps)  // four times as long for half the error
            steps.push_back(
                {levels, false, {1024 / (levels * levels), 512 / (levels * levels), 2048 / (levels * levels)}});
        for (const double levels : {100.0, 32.0, 20.0, 8.0, 3.0, 1.0, 0.5}) {
            const std::optional<Foretold> seconds = secondsAt(steps, levels);
            QVERIFY(seconds && std::abs(seconds->value * levels * levels - 1024) < 1e-6);
            QVERIFY(std::abs(seconds->low * levels * levels - 512) < 1e-6);
            QVERIFY(std::abs(levelsAt(steps, seconds->value) / levels - 1) < 1e-9);
        }
        steps.back().seconds.high = std::numeric_limits<double>::infinity();
        QVERIFY(std::isinf(secondsAt(steps, 1.5)->high) && std::isfinite(secondsAt(steps, 3)->high));
        QVERIFY(!secondsAt({}, 8));
    }

    /// All steps are reached at once, as in an image without noise.
    void stepsAtOneMomentAreAllReachedThen() {
        std::vector<QualityStep> steps;
        for (const double levels : kQualitySteps)
            steps.push_back({levels, true, {2, 2, 2}});
        QCOMPARE(secondsAt(steps, 5)->value, 2.0);
        QVERIFY(std::isfinite(levelsAt(steps, 7)));
    }

    void whatCanBeAskedForIsWhatCanBeSaid() {
        for (const auto& [asked, taken] :
             {std::pair(5.66, 6.0), {3.4, 3.0}, {2.98, 3.0}, {2.94, 2.9}, {1, 1}, {0.01, 0.2}, {1e3, 64}})
            QCOMPARE(nearestTarget(asked), taken);
    }

    void theFirstLimitThatIsReachedEndsARendering() {
        std::vector<QualityStep> steps;
        for (const double levels : kQualitySteps)
            steps.push_back({levels, false, {1024 / (levels * levels), 0, 0}});
        const auto cause = [&](const StopRule& rule) { return foretoldStop(rule, steps, 2, 64)->cause; };
        using Cause = ForetoldStop::Cause;
        QVERIFY(cause({.levels = 8}) == Cause::levels);
        QVERIFY(cause({.levels = 8, .seconds = 17}) == Cause::levels);
        QVERIFY(cause({.levels = 8, .seconds = 15}) == Cause::seconds);
        QVERIFY(cause({.levels = 8, .seconds = 15, .samples = 400}) == Cause::samples);
        const auto stop = foretoldStop({.levels = 1, .samples = 512}, steps, 2, 64);
        QVERIFY(std::abs(stop->seconds - 16) < 1e-9 && std::abs(stop->levels - 8) < 1e-6 && stop->samples == 512);
        QVERIFY(!foretoldStop({}, {}, 2, 64));
        const StopRule rule{.levels = 4, .seconds = 10, .samples = 100};
        QVERIFY(rule.isMet(4, 1, 64) && rule.isMet(9, 10, 1) && rule.isMet(9, 1, 100) && !rule.isMet(4.1, 9.9, 99));
        QVERIFY(!rule.isMet(0.1, 9.9, 63));  // too few samples for an error to count
        QVERIFY(isReached(4, 4, 64) && !isReached(4, 4, 63) && !isReached(4.1, 4, 64));
        const auto early = foretoldStop({.levels = 64}, steps, 2, 16);
        QVERIFY(early->seconds == 8 && early->samples == 64);
        QVERIFY(!StopRule{}.isMet(1.1, 1e9, 1'000'000'000));
    }
};

QTEST_GUILESS_MAIN(ForecastTest)
#include "forecast_test.moc"
