/// Hard cases 1 to 10: adding samples up, and showing the sum. Each naive form is written out and must fail.

#include <QTest>

#include "render/film/display/tone_map.h"
#include "render/kernel/random.h"
#include "tests/support/scenes/images.h"
#include "tests/support/scenes/one_pixel.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

float uniform(std::uint64_t i, std::uint64_t seed = 1) {
    return Random(seed, 0, i).stream(Dimension::filter).pair().x;
}

/// The mean of `count` samples as it is, as our film has it, and as naive sums in single precision have it.
struct Means {
    double truth = 0, ours = 0;
    float running = 0, plain = 0;

    double naiveError() const { return std::fabs(double(running) / truth - 1); }
    double plainError() const { return std::fabs(double(plain) / truth - 1); }
    double ourError() const { return std::fabs(ours / truth - 1); }
};

template <class Value>
Means means(std::uint64_t count, Value&& value) {
    Means result;
    long double sum = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        const float sample = value(i);
        sum += sample;
        result.plain += sample;
        result.running += (sample - result.running) / float(i + 1);
    }
    result.truth = double(sum / count);
    result.plain /= float(count);
    result.ours = test::filmOf(count, value).pixel(0, 0).mean.x;
    return result;
}

/// The tone curve as Exposure Render has it: no guard, truncated.
float naiveLevel(float radiance, float exposure) {
    return 255 * (1 - std::exp(-(radiance * (1 / exposure))));
}

}  // namespace

class AccumulationTest : public QObject {
    Q_OBJECT

  private slots:
    /// Case 1. Root mean square over 20 seeds, since the naive error is itself random.
    void floatRunningMeanIsOffAfter25000Samples() {
        double naive = 0, plain = 0;
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const Means got = means(25000, [=](std::uint64_t i) { return uniform(i, seed) < 0.9f ? 0.8f : 2.8f; });
            naive += got.naiveError() * got.naiveError() / 20;
            plain += got.plainError() * got.plainError() / 20;
            QVERIFY(got.ourError() < 1e-12);
        }
        QVERIFY2(std::sqrt(naive) > 2e-6 && std::sqrt(plain) > 2e-5,
                 qPrintable(QString("%1, %2").arg(std::sqrt(naive)).arg(std::sqrt(plain))));
    }

    /// Cases 2 and 3.
    void floatRunningMeanDriftsByPercentsInTenMillionSamples_data() {
        QTest::addColumn<quint64>("count");
        QTest::addColumn<float>("fraction");
        QTest::addColumn<float>("often");
        QTest::addColumn<float>("seldom");
        QTest::addColumn<double>("naiveError");
        QTest::newRow("1e6") << quint64(1'000'000) << 0.9f << 0.8f << 2.8f << 1e-4;
        QTest::newRow("1e7") << quint64(10'000'000) << 0.9f << 0.8f << 2.8f << 1e-3;
        QTest::newRow("fireflies") << quint64(10'000'000) << 1 - 1e-5f << 1e-3f << 1e4f << 1e-3;
    }
    void floatRunningMeanDriftsByPercentsInTenMillionSamples() {
        QFETCH(quint64, count);
        QFETCH(float, fraction);
        QFETCH(float, often);
        QFETCH(float, seldom);
        QFETCH(double, naiveError);
        const Means got = means(count, [=](std::uint64_t i) { return uniform(i) < fraction ? often : seldom; });
        qInfo("naive %.1e, ours %.1e", got.naiveError(), got.ourError());
        QVERIFY(got.naiveError() > naiveError);
        QVERIFY(got.ourError() < 1e-12);
    }

    /// Case 4.
    void floatSumOfOnesStopsAtSixteenMillion() {
        const std::uint64_t count = 100'000'000;
        float naive = 0;
        for (std::uint64_t i = 0; i < count; ++i)
            naive += 1.0f;
        QCOMPARE(naive, 16777216.0f);
        const Film film = test::filmOf(count, [](std::uint64_t) { return 1.0f; });
        QCOMPARE(film.pixel(0, 0).mean.x, 1.0);
        QCOMPARE(film.pixel(0, 0).standardError.x, 0.0);
        QCOMPARE(film.pixel(0, 0).count, count);
    }

    /// Case 5. The film begins with 2^32 - 64 samples of 0.5 in one block and goes on with ones.
    void sampleCountWrapsAtFourBillion() {
        const std::uint64_t many = (1ull << 32) - 64;
        QVERIFY(std::int32_t(many + 64) == 0 && float(many) + 1 == float(many));  // what int and float make of it
        Film film(ivec2(1, 1), 0);
        *film.sums(test::kOnePixel).pixels = {
            .sum = dvec3(0.5 * double(many)), .sumOfSquares = dvec3(0.25 * double(many)), .count = std::uint32_t(many)};
        film.commit({0, std::uint32_t(many)});
        for (std::uint64_t added = 1; added <= 200; ++added) {
            const SampleRange range = film.nextSamples(1);
            QCOMPARE(range.first, many + added - 1);
            addSample(*film.sums(test::kOnePixel).pixels, vec3(1), range.first);
            film.commit(range);
            const PixelEstimate pixel = film.pixel(0, 0);
            QCOMPARE(pixel.count, many + added);
            QVERIFY(std::fabs(pixel.mean.x - (0.5 * double(many) + double(added)) / double(many + added)) < 1e-15);
        }
    }

    /// Case 5, the numbers: those of sample i and of sample i mod 2^32 must differ, as must all around 2^31 and 2^32.
    void randomNumbersRepeatAfterFourBillionSamples() {
        const auto draw = [](std::uint64_t sample) { return uniform(sample); };
        const auto naive = [&](std::uint64_t sample) { return draw(std::uint32_t(sample)); };
        std::vector<float> seen;
        for (const std::uint64_t about : {1ull << 31, 1ull << 32, 1ull << 33, ~0ull - 500, 0ull})
            for (std::uint64_t i = 0; i < 64; ++i) {
                seen.push_back(draw(about + i));
                QVERIFY(about != 1ull << 32 || naive(about + i) == naive(i));
            }
        std::sort(seen.begin(), seen.end());
        QVERIFY(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
        // And through a device.
        const auto device = makeCpuDevice(1);
        (void)device->upload(test::slab(1, {0, 0, -1}, 0.8f));
        const auto sumsFrom = [&](std::uint64_t first) {
            const Tile area{0, 0, 4, 4};
            const auto film = *device->film(area, 0, {});
            (void)film->resume(Film(area, 0, first));
            (void)film->accumulate(64, {});
            return (*film->film())->pixel(1, 1).mean.x;
        };
        QVERIFY(sumsFrom(1ull << 32) != sumsFrom(0) && sumsFrom(1ull << 32) != sumsFrom(1ull << 31));
    }

    /// Case 6. Kroes' A += (x - A) / max(N, 1) with N = iterations done: the first sample is thrown away.
    void firstSampleIsOverwrittenByTheSecond() {
        const double kroes[] = {1, 2, 2.5}, right[] = {1, 1.5, 2};
        double naive = 0;
        for (int done = 0; done < 3; ++done) {
            naive += (done + 1 - naive) / std::max(done, 1);
            QCOMPARE(naive, kroes[done]);
            const Film film = test::filmOf(std::uint64_t(done + 1), [](std::uint64_t i) { return float(i + 1); });
            QCOMPARE(film.pixel(0, 0).mean.x, right[done]);
        }
    }

    /// Case 7. 1e4 +- 1e-2, as near as float samples come to it.
    void varianceOfSmallNoiseOnALargeValueTurnsNegative() {
        const int count = 100'000;
        std::vector<float> samples;  // once: a compiler may round the same expression in two ways
        for (int i = 0; i < count; ++i)
            samples.push_back(1e4f + 1e-2f * (2 * uniform(std::uint64_t(i)) - 1));
        test::Sample truth;
        float sum = 0, squares = 0;
        double doubleSum = 0, doubleSquares = 0;
        for (const float sample : samples) {
            truth.add(sample);
            sum += sample;
            squares += sample * sample;
            doubleSum += sample;
            doubleSquares += double(sample) * sample;
        }
        const float naive = squares / count - (sum / count) * (sum / count);
        QVERIFY2(naive < 0 || naive > 1000 * truth.variance(), qPrintable(QString::number(naive)));
        const double mean = doubleSum / count;  // even in double one sum of squares loses most of its digits
        QVERIFY(std::fabs((doubleSquares / count - mean * mean) / truth.variance() - 1) > 1e-3);
        const double error =
            test::filmOf(count, [&](std::uint64_t i) { return samples[i]; }).pixel(0, 0).standardError.x;
        QVERIFY(std::fabs(error / truth.standardError() - 1) < 1e-6);
    }

    /// Case 8. In the film, and from a light that is not a number through the whole pipeline.
    void oneSampleThatIsNotANumberPoisonsTheMean() {
        float naive = 0;
        const auto value = [](std::uint64_t i) { return i == 70 ? NAN : i == 90 ? INFINITY : i == 95 ? -1.0f : 2.0f; };
        for (int i = 0; i < 200; ++i)
            naive += (value(std::uint64_t(i)) - naive) / float(i + 1);
        QVERIFY(std::isnan(naive));
        const Film film = test::filmOf(200, value);
        QCOMPARE(film.pixel(0, 0).mean.x, 2.0);
        QCOMPARE(film.pixel(0, 0).count, std::uint64_t(197));
        const Health health = film.status().health;
        QCOMPARE(health.rejected(), std::uint64_t(3));
        QCOMPARE(health.of(Fault::notANumber).sample, std::uint64_t(70));
        QCOMPARE(health.of(Fault::infinite).sample, std::uint64_t(90));
        QCOMPARE(health.of(Fault::negative).sample, std::uint64_t(95));
        QCOMPARE(film.status().relativeError, 0.0);

        const auto device = makeCpuDevice(1);
        const auto prepared = test::prepared(test::slab(2, {0, 0, -1}, 1));
        for (const float radiance : {NAN, INFINITY}) {
            prepared->lights[0].radiance = vec3(1, radiance, 1);
            const Film image = test::sampled(prepared, 64);
            const Fault fault = std::isnan(radiance) ? Fault::notANumber : Fault::infinite;
            QVERIFY(image.status().health.of(fault).count > 500);
            QVERIFY(std::isfinite(image.status().meanLuminance));
        }
    }

    /// Case 9. Squares of what float just holds.
    void sumsOfHugeSamplesOverflow() {
        for (const float huge : {1e30f, 9e37f}) {
            float naive = 0;
            for (int i = 0; i < 100; ++i)
                naive += huge * huge;
            QVERIFY(std::isinf(naive));
            const Film film = test::filmOf(100, [=](std::uint64_t i) { return i % 2 ? huge : 0; });
            const PixelEstimate pixel = film.pixel(0, 0);
            QVERIFY(std::fabs(pixel.mean.x / (0.5 * double(huge)) - 1) < 1e-12);
            QVERIFY(std::fabs(pixel.standardError.x / (0.5 * double(huge) / std::sqrt(99.0)) - 1) < 1e-12);
            QCOMPARE(int(toneMap(film, {})[0]), 255);
            QVERIFY(std::isfinite(film.status().relativeError));
        }
    }

    /// Case 10. Whatever the radiance and the exposure: a level, never darker for more light.
    void toneCurveOfNothingOverNothingIsNotANumber() {
        QVERIFY(std::isnan(naiveLevel(0, 0)));
        QVERIFY(std::isnan(naiveLevel(0, 1e-45f)));
        QVERIFY(naiveLevel(-0.5f, 1) < 0);  // a byte would wrap to a bright level
        for (const float exposure : {0.0f, 1e-45f, 1e-30f, 0.01f, 1.0f, 100.0f, 1e30f, INFINITY}) {
            int last = 0;
            QCOMPARE(int(displayLevel(0, {exposure})), 0);
            for (const double radiance : {-HUGE_VAL, -1e30, -0.5, 0.0, 1e-320, 1e-30, 1e-3, 0.5, 2.0, 1e30, HUGE_VAL}) {
                const int level = displayLevel(radiance, {exposure});
                QVERIFY(level >= last && level <= 255);
                last = level;
            }
        }
        QCOMPARE(int(displayLevel(1e-300, {0})), 255);  // no exposure: all light is too bright
        QCOMPARE(int(displayLevel(NAN, {1})), 0);
    }
};

QTEST_GUILESS_MAIN(AccumulationTest)
#include "accumulation_test.moc"
