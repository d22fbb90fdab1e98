/// What a film says about its error, held against samples whose error is known in closed form. Statistical bounds are
/// at five standard errors: a false alarm in about a million runs.

#include <QTest>
#include <cmath>

#include "render/accuracy/prediction.h"
#include "render/device/cpu/host_gpu.h"
#include "render/device/gpu/gpu_device.h"
#include "render/film/tone_map.h"
#include "render/kernel/pixel.h"
#include "render/kernel/random.h"

using namespace pdr;

namespace {

constexpr double kSigmas = 5;

double uniform(std::size_t pixel, std::uint64_t sample) {
    return Random(7, std::uint32_t(pixel), sample).stream(Dimension::filter).pair().x;
}

std::size_t pixelsOf(const Film& film) {
    return std::size_t(film.size().x) * std::size_t(film.size().y);
}

/// Goes on to `count` samples: radiance value(pixel, sample) where seen(pixel) is kSeen...
template <class Value, class Seen>
void grow(Film& film, std::uint64_t count, Value&& value, Seen&& seen) {
    const Tile whole{0, 0, film.size().x, film.size().y};
    while (film.samplesPerPixel() < count) {
        const SampleRange range = film.nextSamples(std::uint32_t(std::min<std::uint64_t>(
            64, count - film.samplesPerPixel())));
        for (std::size_t pixel = 0; pixel < pixelsOf(film); ++pixel) {
            PixelSums& sums = film.sums(whole).pixels[pixel];
            sums.seen |= seen(pixel);
            for (std::uint32_t i = 0; i < range.count; ++i)
                addSample(sums, vec3(float(value(pixel, range.first + i))));
        }
        film.commit(range);
    }
}

/// A film whose pixels hold n samples, half of them mean + spread, half mean - spread: its standard error is
/// spread / sqrt(n - 1), without any chance.
struct Known {
    double mean, spread;
    std::uint32_t seen = kSeenTissue | kSeenChance;
};
Film filmOf(const std::vector<Known>& pixels, std::uint32_t n) {
    FilmContent content{n, std::vector<Moments>(pixels.size()), std::vector<PixelSums>(pixels.size()), {}};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const auto& [mean, spread, seen] = pixels[i];
        content.moments[i] = {dvec3(mean), dvec3(n * spread * spread), n};
        content.block[i].seen = seen;
    }
    return Film({int(pixels.size()), 1}, 1, std::move(content));
}

/// The status that a screen is told, by the CPU and by a GPU's programs; they must agree.
FilmStatus shownStatus(const Film& film, float exposure) {
    const FilmStatus cpu = pictureOf(film, {exposure}).status;
    GpuDevice<HostGpu> device(DeviceInfo{"host", "", false}, std::size_t(0));
    const auto live = *device.film(film.size(), 1, {});
    if (!live->resume(film) || !live->show({exposure}))
        return {};
    const Result<Picture> picture = live->take();
    if (!picture || picture->status.displayError != cpu.displayError ||
        picture->status.tissuePixels != cpu.tissuePixels ||
        picture->status.fewBrightSamples != cpu.fewBrightSamples || picture->status.unseenShare != cpu.unseenShare ||
        !(std::fabs(picture->status.relativeError - cpu.relativeError) <= 1e-12 * cpu.relativeError ||
          picture->status.relativeError == cpu.relativeError))
        return {};
    return cpu;
}

/// The tone curve written down once more, unrounded.
double curve(double radiance, double exposure) {
    const double light = -std::expm1(-std::max(radiance, 0.0) / exposure);
    return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

double twoSided(double mean, double standardError, double exposure) {
    const double here = curve(mean, exposure);
    return std::max(here - curve(mean - 2 * standardError, exposure), curve(mean + 2 * standardError, exposure) - here);
}

/// The spread that n samples about `mean` must have for the screen to be `levels` off.
double spreadFor(double levels, double mean, double exposure, std::uint32_t n) {
    double low = 0, high = 10 * mean;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (twoSided(mean, middle / std::sqrt(n - 1.0), exposure) < levels ? low : high) = middle;
    }
    return high;
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
        double squares = 0, covered = 0, missed = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const PixelEstimate pixel = film.pixel(x, y);
                QVERIFY(pixel.tissue && pixel.count == n);
                squares += pixel.standardError.x * pixel.standardError.x / pixels;
                covered += std::fabs(pixel.mean.x - 0.5) <= 1.96 * pixel.standardError.x;
                missed += (pixel.mean.x - 0.5) * (pixel.mean.x - 0.5) / pixels;
            }
        const double truth = 1.0 / 12 / double(n);
        QVERIFY(std::fabs(squares / truth - 1) < kSigmas * std::sqrt(0.8 / double(n) / pixels));
        QVERIFY(std::fabs(missed / truth - 1) < kSigmas * std::sqrt(2 / pixels));
        QVERIFY(std::fabs(covered / pixels - 0.95) < kSigmas * std::sqrt(0.95 * 0.05 / pixels));
    }

    /// Tissue of two kinds among empty ground and a noisy background that no sample met tissue before.
    void theRelativeErrorIsThatOfTheTissueAlone() {
        const std::uint64_t n = 300;
        const auto kind = [](std::size_t pixel) { return pixel % 4; };
        Film film({60, 40}, 0);
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
        // Half of the variance's relative error (9/10 of it from 600 pixels), and that of the mean.
        const double allowed = kSigmas * std::hypot(0.5 * std::sqrt(0.8 / double(n) / 600), truth / std::sqrt(1200));
        QVERIFY2(std::fabs(status.relativeError / truth - 1) < allowed,
                 qPrintable(QString("%1 %2").arg(status.relativeError / truth).arg(allowed)));
        QVERIFY(std::fabs(status.meanLuminance / ((0.5 + 2.5 + 10) / 4) - 1) < 0.01);
    }

    void theCurveBeforeRoundingIsTheCurve() {
        float worst = 0, last = 0;
        for (double share = 1e-9; share < 1e3; share *= 1.0007) {
            const float level = exactLevelOf(displayCurve(), float(share));
            worst = std::max(worst, float(std::fabs(level - curve(share, 1))));
            QVERIFY(level >= last && level <= 255);
            last = level;
        }
        QVERIFY2(worst < 0.005f, qPrintable(QString::number(worst)));
        QCOMPARE(exactLevelOf(displayCurve(), 0), 0.0f);
        QCOMPARE(exactLevelOf(displayCurve(), INFINITY), 255.0f);
        QCOMPARE(exactLevelOf(displayCurve(), NAN), 0.0f);
    }

    /// Bright, in the dark, where the interval reaches below black, and near white.
    void aPixelIsOffByItsFartherEnd() {
        const auto off = [](dvec3 mean, dvec3 standardError, double exposure) {
            return levelsOff(displayCurve(), mean, standardError, exposure);
        };
        for (const double exposure : {0.5, 4.0})
            for (const double mean : {1e-4, 0.003, 0.1, 0.7, 3.0, 20.0})
                for (const double share : {1e-3, 0.03, 0.3, 0.49, 0.51, 2.0, 40.0}) {
                    const double got = off(dvec3(mean), dvec3(share * mean), exposure);
                    QVERIFY2(std::fabs(got - twoSided(mean, share * mean, exposure)) < 0.01,
                             qPrintable(QString("%1 %2: %3").arg(mean).arg(share).arg(got)));
                }
        const double slope = (curve(0.10001, 1) - curve(0.1, 1)) / 1e-5;
        QVERIFY(twoSided(0.1, 0.04, 1) > 2 * 0.04 * slope + 9);  // the slope alone is wrong by levels
        QVERIFY(std::fabs(off(dvec3(0.5, 0.5, 3), dvec3(0.01, 0.2, 0), 1) - twoSided(0.5, 0.2, 1)) < 0.01);
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
            pixels.push_back({mean, spreadFor((i + 0.5) / 2000 * most, mean, exposure, n)});
        }
        const double alone = shownStatus(filmOf(pixels, n), exposure).displayError;
        QVERIFY2(std::fabs(alone - 0.95 * most) < tolerance, qPrintable(QString::number(alone)));
        for (int i = 0; i < 6000; ++i)  // and ground beside them, of which no sample met tissue
            pixels.push_back({i % 2 ? 0.0 : 1.0, i % 2 ? 0.0 : 9.0, kSeenChance});
        QCOMPARE(shownStatus(filmOf(pixels, n), exposure).displayError, alone);
    }

    void nothingIsSaidOfLevelsFromFewSamples() {
        const std::vector<Known> pixels(50, {0.5, 0.2});
        QVERIFY(std::isinf(shownStatus(filmOf(pixels, 31), 1).displayError));
        QVERIFY(std::isfinite(shownStatus(filmOf(pixels, 32), 1).displayError));
        QVERIFY(std::isinf(filmOf(pixels, 32).status().displayError));  // without a display
        const std::vector<Known> ground(50, {0.5, 0.2, 0});
        QVERIFY(std::isinf(shownStatus(filmOf(ground, 32), 1).displayError));
        QVERIFY(std::isfinite(shownStatus(filmOf(ground, 32), 1).relativeError));  // of all pixels
    }

    /// 10 % of the tissue has seen no light: of n samples 3 / n may still be as bright as those that did elsewhere.
    void tissueWithoutLightIsNotWithoutError() {
        const std::uint32_t n = 64;
        std::vector<Known> pixels(900, {0.5, 0.5});  // samples of 0 and of 1
        pixels.insert(pixels.end(), 100, {0, 0});
        const double bright = (0.25 + n * 0.25 / (n - 1)) / 0.5;
        const double known = twoSided(0.5, 0.5 / std::sqrt(n - 1.0), 1), unlit = curve(3.0 / n * bright, 1);
        QVERIFY(unlit > known + 5);
        const double off = shownStatus(filmOf(pixels, n), 1).displayError;
        QVERIFY2(std::fabs(off - unlit) < 0.4, qPrintable(QString("%1, not %2").arg(off).arg(unlit)));
        for (Known& pixel : pixels)
            pixel.seen = kSeenTissue;  // black is what it is, where chance has no part
        QVERIFY(std::fabs(shownStatus(filmOf(pixels, n), 1).displayError - known) < 0.4);
    }

    void nothingSeenYetIsUnknownAndNotWithoutError() {
        for (const double all : {0.0, 1.0}) {
            const FilmStatus status = shownStatus(filmOf(std::vector<Known>(20, {all, 0}), 640), 1);
            QVERIFY(std::isinf(status.relativeError) && std::isinf(status.displayError));
            QCOMPARE(status.unseenShare, 3 / (640.0 * 20));
        }
        const FilmStatus sure = shownStatus(filmOf(std::vector<Known>(20, {1, 0, kSeenTissue}), 640), 1);
        QCOMPARE(sure.relativeError, 0.0);
        QCOMPARE(sure.displayError, 0.0);
        QCOMPARE(sure.unseenShare, 0.0);
    }

    /// What was foretold from 64 samples is there when they are taken.
    void whatIsForetoldComesTrue() {
        Film film({40, 40}, 0);
        const auto goOn = [&](double count) {
            grow(film, std::uint64_t(std::llround(count)), uniform,
                 [](std::size_t) { return kSeenTissue | kSeenChance; });
            return pictureOf(film, {0.3f}).status;
        };
        const FilmStatus early = goOn(64);
        QVERIFY(!early.fewBrightSamples);
        const double truth = 64 * 16;  // a quarter of the error
        QVERIFY(std::fabs(samplesToReach(early.relativeError / 4, early) / truth - 1) < 1e-12);
        const auto step = nextQualityStep(early, 10);
        QVERIFY(step && !step->atLeast && step->levels < early.displayError);
        const FilmStatus later = goOn(64 + 10 * step->seconds);
        QVERIFY2(std::fabs(later.displayError / step->levels - 1) < 0.06,
                 qPrintable(QString("%1 for %2").arg(later.displayError).arg(step->levels)));
        const FilmStatus late = goOn(truth);
        QVERIFY(std::fabs(late.relativeError / (early.relativeError / 4) - 1) < 0.01);
    }

    /// One sample in a hundred brings light: what few samples tell is a lower bound, and said to be one.
    void rareLightMakesTheForecastALowerBound() {
        Film film({30, 30}, 0);
        const auto rare = [](std::size_t pixel, std::uint64_t sample) { return uniform(pixel, sample) < 0.01 ? 50 : 0; };
        const auto seen = [](std::size_t) { return kSeenTissue | kSeenChance; };
        grow(film, 64, rare, seen);
        QVERIFY(shownStatus(film, 1).fewBrightSamples);
        QVERIFY(nextQualityStep(shownStatus(film, 1), 1)->atLeast);
        grow(film, 2000, rare, seen);
        QVERIFY(!shownStatus(film, 1).fewBrightSamples);
    }

    /// Tissue that only the first of many samples met is still tissue: in later blocks, and on another device.
    void whatWasSeenStaysSeen() {
        Film film({2, 1}, 0);
        grow(film, 1, uniform, [](std::size_t pixel) { return pixel == 0 ? kSeenTissue : 0; });
        grow(film, 1000, uniform, [](std::size_t) { return 0; });
        QVERIFY(film.pixel(0, 0).tissue && !film.pixel(1, 0).tissue);
        QCOMPARE(shownStatus(film, 1).tissuePixels, std::uint64_t(1));
        FilmContent other = film.content();
        QVERIFY(sameBits(film.content(), other));
        other.block[1].seen = kSeenTissue;
        QVERIFY(!sameBits(film.content(), other));
    }

    /// Through the program that adds a GPU's samples up: the mean and error of the CPU's film, after 1e7 iterations.
    void tenMillionIterationsOnAGpuAreThoseOfTheCpu() {
        const std::uint64_t count = 10'000'000;
        const std::uint32_t launch = 2500;
        const auto value = [](std::size_t, std::uint64_t sample) {
            return float(0.3 + 1e-3 * double(sample % 1009) + (sample % 65'537 == 0 ? 1e4 : 0));
        };
        Film film({1, 1}, 0);
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
            gpu.launch(AccumulateProgram{target, 1, &sums, &moments}, 1, GpuStream::compute);
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
