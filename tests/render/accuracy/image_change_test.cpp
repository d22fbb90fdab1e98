/// By how much images differ, behind noise: fields of known differences, and a rendered one that is known from many
/// samples. 40 seeds each; fewer than 38 of 40 intervals of 95 % would be 93 % of them.

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "render/accuracy/image_change.h"
#include "render/film/display_transform.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

constexpr int kSeeds = 40, kFewest = 38;
constexpr int kPixels = 1500;

/// Returns the levels by which pixel i of kPixels differs.
using Field = std::function<double(int i, std::mt19937& random)>;

double uniform(std::mt19937& random) {
    return std::uniform_real_distribution<double>(0, 1)(random);
}

double normal(std::mt19937& random) {
    return std::normal_distribution<double>()(random);
}

bool holds(const Foretold& told, double truth) {
    constexpr double kRounding = 1e-4;
    return told.low <= truth + kRounding && truth <= told.high + kRounding && told.low <= told.value &&
           told.value <= told.high;
}

double ninetyFifth(std::vector<double> values) {
    std::ranges::sort(values);
    return values[std::size_t(0.95 * double(values.size() - 1))];
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
        sum += value;
    return sum / double(values.size());
}

bool isNothing(const ImageChange& change) {
    return change.mean.high == 0 && change.ninetyFifth.high == 0;
}

/// Returns the true differences with noise: two halves per pixel, whose mean is off by `noise` levels.
std::vector<HalfDifferences> seenThrough(const std::vector<double>& truth, double noise, std::mt19937& random) {
    std::vector<HalfDifferences> pixels;
    for (const double d : truth) {
        const double half = noise * std::sqrt(2.0), even = d + half * normal(random), odd = d + half * normal(random);
        pixels.push_back({vec3(float(even)), vec3(float(odd))});
    }
    return pixels;
}

}  // namespace

class ImageChangeTest : public QObject {
    Q_OBJECT

  private slots:
    /// Two films without noise: what is told is the mean over the channels of how far the screen's levels are apart.
    void coloursChangeByWhatTheScreenShows_data() {
        QTest::addColumn<ToneCurve>("curve");
        QTest::newRow("keepsHue") << ToneCurve::keepsHue;
        QTest::newRow("perChannel") << ToneCurve::perChannel;
    }
    void coloursChangeByWhatTheScreenShows() {
        QFETCH(ToneCurve, curve);
        const Display display{.exposure = 0.7f, .curve = curve};
        const DisplayTransform transform = displayTransform(display);
        const dvec3 tissue[] = {{1, 0.69, 0.36}, {1, 0.12, 0.08}, {0.2, 0.3, 1}, {1, 1, 1}, {0.5, 1, 1}};
        for (const dvec3 from : tissue)
            for (const dvec3 to : tissue)
                for (const double brighter : {0.0, 0.5, 1.0, 1.2, 3.0}) {
                    Film with(ivec2(1, 1), 1), without(ivec2(1, 1), 1);
                    const auto set = [](Film& film, dvec3 mean) {
                        film.sums(wholeImage(film.size())).pixels[0] = {.sum = 2.0 * mean,
                                                                        .sumOfSquares = 2.0 * mean * mean,
                                                                        .evenSum = vec3(mean),
                                                                        .evenCount = 1,
                                                                        .count = 2,
                                                                        .seen = kSeenTissue};
                        film.commit({0, 2});
                    };
                    set(with, 0.8 * from), set(without, 0.8 * brighter * to);
                    const vec3 apart =
                        glm::abs(transform.exactLevels(0.8 * from) - transform.exactLevels(0.8 * brighter * to));
                    const double truth = double(apart.x + apart.y + apart.z) / 3;
                    const double told = imageChange(with, without, display).mean.value;
                    QVERIFY2(std::fabs(told - truth) < 0.1 + 0.01 * truth,
                             qPrintable(QString("%1 for %2").arg(told).arg(truth)));
                }
    }

    void intervalsHoldWhatIsTrue_data() {
        QTest::addColumn<Field>("field");
        const Field nothing = [](int, auto&) { return 0.0; };
        const Field even = [](int, auto&) { return 10.0; };
        const Field bell = [](int, auto& random) { return 8 * normal(random); };
        const Field ramp = [](int i, auto&) { return 40.0 * i / kPixels; };
        const Field tenth = [](int, auto& random) { return uniform(random) < 0.1 ? -20.0 : 0.0; };
        const Field few = [](int i, auto&) { return i % 33 == 0 ? 40.0 : 0.0; };
        const Field faint = [](int, auto& random) { return 0.5 * normal(random); };
        QTest::newRow("nothing") << nothing;
        QTest::newRow("the same everywhere") << even;
        QTest::newRow("up and down") << bell;
        QTest::newRow("a ramp") << ramp;
        QTest::newRow("a tenth of the picture") << tenth;
        QTest::newRow("too few for the percentile") << few;
        QTest::newRow("less than the noise") << faint;
    }
    void intervalsHoldWhatIsTrue() {
        QFETCH(Field, field);
        for (const double noise : {0.0, 0.5, 3.0, 10.0}) {
            int means = 0, percentiles = 0;
            for (unsigned seed = 0; seed < kSeeds; ++seed) {
                std::mt19937 random(seed);
                std::vector<double> truth, sizes;
                for (int i = 0; i < kPixels; ++i) {
                    truth.push_back(field(i, random));
                    sizes.push_back(std::fabs(truth.back()));
                }
                const ImageChange change = changeOf(seenThrough(truth, noise, random));
                means += holds(change.mean, mean(sizes));
                percentiles += holds(change.ninetyFifth, ninetyFifth(sizes));
                if (seed == 0)
                    qInfo("noise %g: mean %.2f told %.2f (%.2f to %.2f), 95 %% %.2f told %.2f (%.2f to %.2f)", noise,
                          mean(sizes), change.mean.value, change.mean.low, change.mean.high, ninetyFifth(sizes),
                          change.ninetyFifth.value, change.ninetyFifth.low, change.ninetyFifth.high);
            }
            QVERIFY2(means >= kFewest && percentiles >= kFewest,
                     qPrintable(QString("noise %1: %2, %3").arg(noise).arg(means).arg(percentiles)));
        }
    }

    void withoutNoiseThereIsNothingToGuess() {
        std::mt19937 random(1);
        std::vector<double> truth, sizes;
        for (int i = 0; i < kPixels; ++i) {
            truth.push_back(8 * normal(random));
            sizes.push_back(std::fabs(truth.back()));
        }
        const ImageChange change = changeOf(seenThrough(truth, 0, random));
        QVERIFY(std::fabs(change.mean.value - mean(sizes)) < 0.01);
        QVERIFY(std::fabs(change.ninetyFifth.value - ninetyFifth(sizes)) < 0.1);
        QVERIFY(change.mean.high - change.mean.low < 0.6 && change.ninetyFifth.high - change.ninetyFifth.low < 3);
    }

    /// The observed difference is 2.4 levels on average, all of it noise.
    void noiseIsNoDifference() {
        std::mt19937 random(1);
        const std::vector<double> nothing(kPixels, 0.0);
        const ImageChange change = changeOf(seenThrough(nothing, 3, random));
        QVERIFY2(change.mean.value < 0.5 && change.mean.high < 1.2, qPrintable(QString::number(change.mean.high)));
        QCOMPARE(change.ninetyFifth.low, 0.0);
    }

    void imagesOfTheSameSamplesDoNotDiffer() {
        Scene scene = test::plainScene(test::bumpyVolume({20, 20, 20}, dvec3(1), 1), 0.3f);
        scene.film = {16, 16};
        const Film one = test::render(scene, 32);
        QVERIFY(isNothing(imageChange(one, one, {})));
        QVERIFY(isNothing(imageChange(Film(ivec2(0), 1), Film(ivec2(0), 1), {})));
    }

    /// Compares the change between images of 64 samples, with different random numbers, to that between images of 4096.
    void whatIsRenderedDiffersByWhatManySamplesSay() {
        Scene scene = test::plainScene(test::bumpyVolume({20, 20, 20}, dvec3(1), 1), 0.3f);
        scene.film = {24, 24};
        scene.environment = {vec3(0.2f), false};
        Scene lean = scene;
        lean.environment = {};
        const auto truthOf = [&](const Scene& other) {
            return imageChange(test::render(scene, 4096), test::render(other, 4096), {});
        };
        const ImageChange truth = truthOf(lean), none = truthOf(scene);
        QVERIFY(truth.mean.value > 10 && isNothing(none));
        int means = 0, percentiles = 0, nothings = 0;
        for (unsigned seed = 1; seed <= kSeeds; ++seed) {
            scene.seed = seed;
            const Film with = test::render(scene, 64);
            Scene same = scene;
            lean.seed = same.seed = 1000 + seed;
            const ImageChange change = imageChange(with, test::render(lean, 64), {});
            const ImageChange nothing = imageChange(with, test::render(same, 64), {});
            means += holds(change.mean, truth.mean.value);
            percentiles += holds(change.ninetyFifth, truth.ninetyFifth.value);
            nothings += holds(nothing.mean, 0) && holds(nothing.ninetyFifth, 0);
            if (seed == 1)
                qInfo("truth %.2f, %.2f; told %.2f (%.2f to %.2f), %.2f (%.2f to %.2f); nothing %.2f to %.2f",
                      truth.mean.value, truth.ninetyFifth.value, change.mean.value, change.mean.low, change.mean.high,
                      change.ninetyFifth.value, change.ninetyFifth.low, change.ninetyFifth.high, nothing.mean.low,
                      nothing.mean.high);
        }
        QVERIFY2(means >= kFewest && percentiles >= kFewest && nothings >= kFewest,
                 qPrintable(QString("%1, %2, %3").arg(means).arg(percentiles).arg(nothings)));
    }
};

QTEST_APPLESS_MAIN(ImageChangeTest)
#include "image_change_test.moc"
