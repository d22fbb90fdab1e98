/// Tests the error of what a screen shows: the tone curve, draws of errors and their percentile, in closed form.

#include <QTest>
#include <cmath>

#include "tests/support/scenes/noisy_films.h"

using namespace pdr;
using namespace pdr::test;

class DisplayErrorTest : public QObject {
    Q_OBJECT

  private slots:
    void theCurveBeforeRoundingIsTheCurve() {
        float worst = 0, last = 0;
        for (double fraction = 1e-9; fraction < 1e3; fraction *= 1.0007) {
            const float level = exactLevelOf(displayCurve(), float(fraction));
            worst = std::max(worst, float(std::fabs(level - curve(fraction, 1))));
            QVERIFY(level >= last && level <= 255);
            last = level;
        }
        QVERIFY2(worst < 0.005f, qPrintable(QString::number(worst)));
        QCOMPARE(exactLevelOf(displayCurve(), 0), 0.0f);
        QCOMPARE(exactLevelOf(displayCurve(), INFINITY), 255.0f);
        QCOMPARE(exactLevelOf(displayCurve(), NAN), 0.0f);
    }

    /// The cases are bright, in the dark, where a draw reaches below black, and near white.
    void aPixelIsOffByWhatItsDrawWouldShow() {
        const auto off = [](dvec3 mean, dvec3 draw, double exposure) {
            return levelsOff(displayTransform(exposure), mean, draw);
        };
        const auto truth = [](double mean, double draw, double exposure) {
            return std::fabs(curve(mean + draw, exposure) - curve(mean, exposure));
        };
        for (const double exposure : {0.5, 4.0})
            for (const double mean : {1e-4, 0.003, 0.1, 0.7, 3.0, 20.0})
                for (const double fraction : {1e-3, 0.03, 0.3, 0.97, 1.1, 40.0, -0.001, -0.1, -0.9, -2.0}) {
                    const double got = off(dvec3(mean), dvec3(fraction * mean), exposure);
                    QVERIFY2(std::fabs(got - truth(mean, fraction * mean, exposure)) < 0.01,
                             qPrintable(QString("%1 %2: %3").arg(mean).arg(fraction).arg(got)));
                }
        const double slope = (curve(0.10001, 1) - curve(0.1, 1)) / 1e-5;
        QVERIFY(truth(0.1, -0.08, 1) > 0.08 * slope + 9);  // the slope alone is wrong by levels
        QVERIFY(std::fabs(off(dvec3(0.5, 0.5, 3), dvec3(0.01, -0.2, 0), 1) - truth(0.5, -0.2, 1)) < 0.01);
    }

    /// Pixels that are off by 0 to `most` levels, evenly: 95 % of them by at most 0.95 of it. A bin is 0.27 levels wide
    /// at 19 levels.
    void theDisplayErrorIsTheNinetyFifthPercentile_data() {
        QTest::addColumn<double>("most");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("20 levels") << 20.0 << 0.1;
        QTest::newRow("90 levels") << 90.0 << 0.2;
        QTest::newRow("2 levels") << 2.0 << 0.02;
    }
    void theDisplayErrorIsTheNinetyFifthPercentile() {
        QFETCH(double, most);
        QFETCH(double, tolerance);
        const std::uint32_t n = 100;
        const float exposure = 2;
        std::vector<Known> pixels;
        for (int i = 0; i < 2000; ++i) {
            const double mean = 0.4 + 0.2 * (i % 7);
            pixels.push_back({mean, drawFor((i + 0.5) / 2000 * most, mean, exposure), 1});
        }
        const double alone = shownStatus(knownFilm(pixels, n), exposure).displayError;
        QVERIFY2(std::fabs(alone - 0.95 * most) < tolerance, qPrintable(QString::number(alone)));
        for (int i = 0; i < 6000; ++i)  // and ground beside them, of which no sample met tissue
            pixels.push_back({i % 2 ? 0.0 : 1.0, i % 2 ? 0.0 : 9.0, 9, kSeenChance});
        QCOMPARE(shownStatus(knownFilm(pixels, n), exposure).displayError, alone);
    }

    void nothingIsSaidOfLevelsFromFewSamples() {
        const std::vector<Known> pixels(50, {0.5, 0.2});
        QVERIFY(std::isinf(shownStatus(knownFilm(pixels, 31), 1).displayError));
        QVERIFY(std::isfinite(shownStatus(knownFilm(pixels, 32), 1).displayError));
        QVERIFY(std::isinf(knownFilm(pixels, 32).status().displayError));  // without a display
        const std::vector<Known> ground(50, {0.5, 0.2, 0.2, 0});
        QVERIFY(std::isinf(shownStatus(knownFilm(ground, 32), 1).displayError));
        QVERIFY(std::isfinite(shownStatus(knownFilm(ground, 32), 1).relativeError));  // of all pixels
    }

    /// 10 % of the tissue has seen no light: of n samples 3 / n may still be as bright as those elsewhere.
    void tissueWithoutLightIsNotWithoutError() {
        const std::uint32_t n = 64;
        std::vector<Known> pixels(900, {0.5, 0.0625, 0.5});  // samples of 0 and of 1
        pixels.insert(pixels.end(), 100, {0, 0, 0});
        const double bright = (0.25 + n * 0.25 / (n - 1)) / 0.5;
        const double known = curve(0.5625, 1) - curve(0.5, 1), unlit = curve(3.0 / n * bright, 1);
        QVERIFY(unlit > known + 5);
        const double off = shownStatus(knownFilm(pixels, n), 1).displayError;
        QVERIFY2(std::fabs(off - unlit) < 0.4, qPrintable(QString("%1, not %2").arg(off).arg(unlit)));
        for (Known& pixel : pixels)
            pixel.seen = kSeenTissue;  // black is what it is, where chance has no part
        QVERIFY(std::fabs(shownStatus(knownFilm(pixels, n), 1).displayError - known) < 0.4);
    }

    /// Wisps that few samples meet, beside tissue that every sample meets: the share that none has met is estimated
    /// correctly whatever the number of samples.
    void tissueThatNoSampleMetIsCounted() {
        const ivec2 size(160, 100);
        const auto isWisp = [&](std::size_t pixel) { return int(pixel) % size.x >= 120; };
        for (const std::uint64_t samples : {8, 16, 32, 48}) {
            Film film(size, 1);
            double unseen = 0, all = 0;
            for (std::size_t pixel = 0; pixel < pixelsOf(film); ++pixel) {
                std::uint32_t seen = kSeenChance;
                for (std::uint64_t sample = 0; sample < samples; ++sample)
                    if (!isWisp(pixel) || chance(5, pixel, sample) < 0.04)
                        seen |= seenOfTissue(sample);
                film.sums(wholeImage(size)).pixels[pixel].seen = seen;
                unseen += (seen & kSeenTissue) == 0;
                ++all;
            }
            grow(
                film, samples, [](auto...) { return 0.5; }, [](auto) { return kSeenChance; });
            const double stated = film.status().unseenTissue, truth = unseen / all;
            QVERIFY2(std::fabs(stated / truth - 1) < 0.2, qPrintable(QString("%1 %2").arg(stated).arg(truth)));
        }
    }
};

QTEST_GUILESS_MAIN(DisplayErrorTest)
#include "display_error_test.moc"
