/// Tests the error that a film states against samples whose error is known in closed form. Statistical bounds are at
/// five standard errors: a false alarm in about a million runs.

#include <QTest>
#include <cmath>

#include "render/accuracy/forecast.h"
#include "render/device/emulated/host_gpu.h"
#include "render/device/gpu/trace_kernels.h"
#include "render/kernel/random.h"
#include "tests/support/scenes/known_films.h"
#include "tests/support/scenes/tissue_scene.h"

using namespace pdr;
using namespace pdr::test;

namespace {

constexpr double kSigmas = 5;

double uniform(std::size_t pixel, std::uint64_t sample) {
    return Random(7, std::uint32_t(pixel), sample).stream(Dimension::filter).pair().x;
}

}  // namespace

class ErrorTruthTest : public QObject {
    Q_OBJECT

  private slots:
    /// Evenly spread samples have a variance of 1/12, and its estimate one of 0.8 / n of that squared.
    void theStandardErrorIsThatOfTheSamples() {
        const ivec2 size(48, 48);
        const std::uint64_t n = 200;
        Film film(size, 0);
        grow(film, n, uniform, [](std::size_t) { return kSeenTissue | kSeenChance; });
        const double pixels = double(pixelsOf(film));
        double squares = 0, draws = 0, covered = 0, missed = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const PixelEstimate pixel = film.pixel(x, y);
                QVERIFY(pixel.tissue && pixel.count == n);
                squares += pixel.standardError.x * pixel.standardError.x / pixels;
                draws += pixel.errorDraw.x * pixel.errorDraw.x / pixels;
                covered += std::fabs(pixel.mean.x - 0.5) <= 1.96 * pixel.standardError.x;
                missed += (pixel.mean.x - 0.5) * (pixel.mean.x - 0.5) / pixels;
            }
        const double truth = 1.0 / 12 / double(n);
        QVERIFY(std::fabs(squares / truth - 1) < kSigmas * std::sqrt(0.8 / double(n) / pixels));
        QVERIFY(std::fabs(draws / truth - 1) < kSigmas * std::sqrt(2 / pixels));
        QVERIFY(std::fabs(missed / truth - 1) < kSigmas * std::sqrt(2 / pixels));
        QVERIFY(std::fabs(covered / pixels - 0.95) < kSigmas * std::sqrt(0.95 * 0.05 / pixels));
    }

    /// Tissue of two kinds among empty ground and a noisy background that no sample met tissue before.
    void theRelativeErrorIsThatOfTheTissueAlone() {
        const std::uint64_t n = 300;
        const auto kind = [](std::size_t pixel) { return pixel % 4; };
        Film film(ivec2(60, 40), 0);
        grow(
            film, n,
            [&](std::size_t pixel, std::uint64_t sample) {
                const double u = uniform(pixel, sample);
                return kind(pixel) == 0 ? u : kind(pixel) == 1 ? 1 + 3 * u : kind(pixel) == 2 ? 0 : 20 * u;
            },
            [&](std::size_t pixel) { return kind(pixel) < 2 ? kSeenTissue | kSeenChance : kSeenChance; });
        const FilmStatus status = shownStatus(film, 1);
        const double truth = std::sqrt((1 + 9) / 2.0 / 12 / double(n)) / ((0.5 + 2.5) / 2);
        QCOMPARE(status.tissuePixels, std::uint64_t(1200));
        // Half of the variance's relative error (9/10 of it from the draws of 600 pixels), and that of the mean.
        const double allowed = kSigmas * std::hypot(0.5 * std::sqrt(2.0 / 600), truth / std::sqrt(1200));
        QVERIFY2(std::fabs(status.relativeError / truth - 1) < allowed,
                 qPrintable(QString("%1 %2").arg(status.relativeError / truth).arg(allowed)));
        QVERIFY(std::fabs(status.meanLuminance / ((0.5 + 2.5 + 10) / 4) - 1) < 0.01);
    }

    void nothingSeenYetIsUnknownAndNotWithoutError() {
        for (const double all : {0.0, 1.0}) {
            const FilmStatus status = shownStatus(knownFilm(std::vector<Known>(20, {all, 0, 0}), 640), 1);
            QVERIFY(std::isinf(status.relativeError) && std::isinf(status.displayError));
            QCOMPARE(status.unseenShare, 3 / (640.0 * 20));
        }
        const FilmStatus sure = shownStatus(knownFilm(std::vector<Known>(20, {1, 0, 0, kSeenTissue}), 640), 1);
        QCOMPARE(sure.relativeError, 0.0);
        QCOMPARE(sure.displayError, 0.0);
        QCOMPARE(sure.unseenShare, 0.0);
    }

    /// The error predicted from some samples is reached when more are taken.
    void whatIsForetoldComesTrue() {
        Film film(ivec2(200, 200), 0);  // 40,000 draws: 0.35 % of their root mean square
        const auto goOn = [&](double count) {
            grow(film, std::uint64_t(std::llround(count)), uniform,
                 [](std::size_t) { return kSeenTissue | kSeenChance; });
            return imageOf(film, {0.3f}).status;
        };
        const FilmStatus early = goOn(64);
        QVERIFY(!early.fewBrightSamples);
        ErrorHistory history;
        history.add(64, early);
        double error = early.displayError;
        for (const double n : {128, 256, 512, 1024}) {
            error = goOn(n).displayError;
            history.add(n, imageOf(film, {0.3f}).status);
        }
        const Foretold foretold = history.samples(error / 2);  // of independent samples, which are not as others are
        QVERIFY(foretold.low < 4096 && foretold.high > 4096);
        const FilmStatus later = goOn(foretold.value);
        QVERIFY2(std::fabs(later.displayError / (error / 2) - 1) < 0.06,
                 qPrintable(QString("%1 for %2").arg(later.displayError).arg(error / 2)));
        QVERIFY(std::fabs(later.relativeError / early.relativeError * std::sqrt(foretold.value / 64) - 1) <
                kSigmas * 0.005);
    }

    /// Over seeds the stated percentile lies about its mean as far as it says.
    void theDisplayErrorKnowsHowSureItIs() {
        const int seeds = 200;
        double sum = 0, squares = 0, stated = 0;
        for (int seed = 0; seed < seeds; ++seed) {
            Film film(ivec2(25, 20), 0);
            grow(
                film, 32,
                [&](std::size_t pixel, std::uint64_t n) { return uniform(pixel + 500 * std::size_t(seed), n); },
                [](std::size_t) { return kSeenTissue | kSeenChance; });
            const FilmStatus status = shownStatus(film, 0.3f);
            sum += status.displayError, squares += status.displayError * status.displayError;
            stated += status.displayErrorSpread / seeds;
        }
        const double spread = std::sqrt((squares - sum * sum / seeds) / (seeds - 1));
        QVERIFY2(std::fabs(stated / spread - 1) < kSigmas * std::sqrt(0.5 / seeds),
                 qPrintable(QString("%1 for %2").arg(stated).arg(spread)));
    }

    /// Most pixels are what one sample made of them, and so dim that nearly all noise is that of the others.
    void dimPixelsOfRareLightAreNothing() {
        std::vector<Known> pixels(300, {0.001, 0.001, 0.008});
        pixels.resize(400, {1, 0.1, 0.8});
        QVERIFY(!shownStatus(knownFilm(pixels, 64), 1).fewBrightSamples);
        pixels.resize(440, {1, 1, 8});  // a tenth, with nearly all of the noise
        QVERIFY(shownStatus(knownFilm(pixels, 64), 1).fewBrightSamples);
    }

    /// Where one sample in a hundred brings light, the error from few samples is a lower bound, and is reported as one.
    void rareLightMakesTheForecastALowerBound() {
        Film film(ivec2(30, 30), 0);
        const auto rare = [](std::size_t pixel, std::uint64_t sample) {
            return uniform(pixel, sample) < 0.01 ? 50 : 0;
        };
        const auto seen = [](std::size_t) { return kSeenTissue | kSeenChance; };
        grow(film, 64, rare, seen);
        QVERIFY(shownStatus(film, 1).fewBrightSamples);
        grow(film, 2000, rare, seen);
        QVERIFY(!shownStatus(film, 1).fewBrightSamples);
    }

    /// The gain of low-discrepancy points is the excess of standard errors, where enough pixels show it.
    void theGainIsThatOverIndependentSamples() {
        std::vector<Known> pixels(99, {1, 0.02, 0.8});
        const std::uint32_t n = 64;
        QCOMPARE(shownStatus(knownFilm(pixels, n), 1).gain, 0.0);
        pixels.push_back({1, 0.02, 0.8});
        QVERIFY(std::fabs(shownStatus(knownFilm(pixels, n), 1).gain * 0.02 / 0.8 * std::sqrt(n - 1.0) - 1) < 1e-4);
    }

    /// A twentieth of the tissue decides the margin stated for 95 % of it.
    void tissueWithoutLightDecidesWhatIsSaidWhereThereIsEnoughOfIt() {
        std::vector<Known> pixels(100, {1, 0.02, 0.8});
        std::fill_n(pixels.begin(), 5, Known{0, 0, 0});
        QVERIFY(!shownStatus(knownFilm(pixels, 64), 1).unlitTissue);
        pixels[5] = {0, 0, 0};
        QVERIFY(shownStatus(knownFilm(pixels, 64), 1).unlitTissue);
        std::fill_n(pixels.begin(), 6, Known{0, 0, 0, kSeenTissue});  // chance has no part in it
        QVERIFY(!shownStatus(knownFilm(pixels, 64), 1).unlitTissue);
    }

    /// Draws of few pixels are poor evidence: there the standard errors are used, which are never too small.
    void ofFewPixelsTheStandardErrorsHold() {
        std::vector<Known> pixels(99, {1, 0.001, 1});
        const std::uint32_t n = 64;
        QVERIFY(std::fabs(shownStatus(knownFilm(pixels, n), 1).relativeError * std::sqrt(n - 1.0) - 1) < 1e-6);
        pixels.push_back({1, 0.001, 1});
        QVERIFY(std::fabs(shownStatus(knownFilm(pixels, n), 1).relativeError / 0.001 - 1) < 1e-4);
    }

    /// In a real scene, compared with a far better image of it, 95 % of the tissue lies within the margin stated for 95
    /// %, and nearly all pixels within their two standard errors, which low-discrepancy points stay below.
    void anImageLiesWhereItSays() {
        Scene scene = test::tissueScene();
        scene.film = {30, 22};
        const float exposure = 0.5f;
        const Film best = test::render(scene, 3000);
        for (const std::uint64_t n : {32, 128}) {
            double tissue = 0, within = 0, withinOwn = 0;
            for (scene.seed = 100; scene.seed < 108; ++scene.seed) {
                const Film film = test::render(scene, n);
                const FilmStatus status = shownStatus(film, exposure);
                QVERIFY(status.displayError > 1 && status.displayError < 200 && !status.fewBrightSamples);
                for (int y = 0; y < film.size().y; ++y)
                    for (int x = 0; x < film.size().x; ++x) {
                        const PixelEstimate pixel = film.pixel(x, y), truth = best.pixel(x, y);
                        if (!pixel.tissue)
                            continue;
                        double off = 0;
                        for (int channel = 0; channel < 3; ++channel)
                            off = std::max(off, std::fabs(curve(pixel.mean[channel], exposure) -
                                                          curve(truth.mean[channel], exposure)));
                        ++tissue;
                        within += off <= status.displayError;
                        const dvec3 outside = glm::abs(pixel.mean - truth.mean) - 2.0 * pixel.standardError;
                        withinOwn += glm::max(glm::max(outside.x, outside.y), outside.z) <= 0;
                    }
            }
            qInfo("%llu samples: %.1f %% of the tissue within its own error, %.1f %% within that of 95 %%",
                  static_cast<unsigned long long>(n), 100 * withinOwn / tissue, 100 * within / tissue);
            QVERIFY(within / tissue > 0.93 && within / tissue < 0.97);
            QVERIFY(withinOwn / tissue > 0.95);
        }
    }

    /// Tissue that only the first of many samples met is still tissue: in later blocks, and on another device.
    void whatWasSeenStaysSeen() {
        Film film(ivec2(2, 1), 0);
        grow(film, 1, uniform, [](std::size_t pixel) { return pixel == 0 ? kSeenTissue : 0; });
        grow(film, 1000, uniform, [](std::size_t) { return 0; });
        QVERIFY(film.pixel(0, 0).tissue && !film.pixel(1, 0).tissue);
        QCOMPARE(shownStatus(film, 1).tissuePixels, std::uint64_t(1));
        FilmContent other = film.content();
        QVERIFY(sameBits(film.content(), other));
        other.block[1].seen = kSeenTissue;
        QVERIFY(!sameBits(film.content(), other));
    }

    /// The program that adds up a GPU's samples gives the mean and error of the CPU's film, after 1e7 iterations.
    void tenMillionIterationsOnAGpuAreThoseOfTheCpu() {
        const std::uint64_t count = 10'000'000;
        const std::uint32_t launch = 2500;
        const auto value = [](std::size_t, std::uint64_t sample) {
            return float(0.3 + 1e-3 * double(sample % 1009) + (sample % 65'537 == 0 ? 1e4 : 0));
        };
        Film film(ivec2(1, 1), 0);
        grow(film, count, value, [](std::size_t) { return kSeenTissue; });
        HostGpu gpu(0, 1);
        std::vector<vec3> radiance(launch);
        std::uint32_t seen = kSeenTissue;
        GpuHealth health;
        PixelSums sums;
        Moments moments;
        long double truth = 0;
        for (std::uint64_t first = 0; first < count; first += launch) {
            for (std::uint32_t i = 0; i < launch; ++i) {
                radiance[i] = vec3(value(0, first + i));
                truth += (long double)(radiance[i].x);
            }
            const TraceTarget target{{{0, 0, 1, 1}, {first, launch}}, radiance.data(), &health, &seen};
            gpu.launch(AccumulateKernel{target, 1, &sums, &moments}, 1, GpuStream::compute);
        }
        gpu.awaitAll();
        const Moments all = merged(moments, sums);
        QVERIFY(all.mean == film.pixel(0, 0).mean && standardErrorOf(all) == film.pixel(0, 0).standardError);
        QCOMPARE(all.count, count);
        QVERIFY(sums.seen == kSeenTissue);
        QVERIFY(std::fabs(double(all.mean.x / (truth / (long double)(count))) - 1) < 1e-12);
    }
};

QTEST_GUILESS_MAIN(ErrorTruthTest)
#include "error_truth_test.moc"
