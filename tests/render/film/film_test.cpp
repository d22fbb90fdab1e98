#include <QTest>
#include <cmath>
#include <cstring>

#include "render/film/film.h"
#include "render/kernel/random.h"
#include "tests/support/scenes/one_pixel.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

double uniform(std::uint64_t i) {
    return Random(1, 0, i).stream(Dimension::filter).pair().x;
}

}  // namespace

class FilmTest : public QObject {
    Q_OBJECT

  private slots:
    /// The padding between numbers in memory does not count; a comparison of bytes would include it.
    void filmsAreComparedNumberByNumber() {
        const auto contentOver = [](unsigned char rubbish, double lastSum, double lastMean) {
            FilmContent content = Film(ivec2(3, 1), 1).content();
            content.progress.advance(content.progress.area(), 2);
            std::memset(static_cast<void*>(content.block.data()), rubbish, 3 * sizeof(PixelSums));
            for (PixelSums& pixel : content.block) {
                pixel.sum = pixel.sumOfSquares = dvec3(0.5);
                pixel.evenSum = vec3(0.25f);
                pixel.evenCount = 1;
                pixel.count = 2;
                pixel.seen = kSeenTissue;
            }
            content.block[2].sum.z = lastSum;
            content.moments[2].mean.x = lastMean;
            return content;
        };
        QVERIFY(sameBits(contentOver(0x00, 1, 1), contentOver(0xff, 1, 1)));
        QVERIFY(!sameBits(contentOver(0, 1, 1), contentOver(0, std::nextafter(1, 2), 1)));
        QVERIFY(!sameBits(contentOver(0, 1, 1), contentOver(0, 1, std::nextafter(1, 2))));
        QVERIFY(!sameBits(contentOver(0, 1, 0.0), contentOver(0, 1, -0.0)));
        FilmContent more = contentOver(0, 1, 1);
        more.progress.advance(more.progress.area(), 3);
        QVERIFY(!sameBits(contentOver(0, 1, 1), more));
        more = contentOver(0, 1, 1);
        more.block[1].seen = 0;
        QVERIFY(!sameBits(contentOver(0, 1, 1), more));
    }

    void firstSamplesCountFully() {
        const auto ramp = [](std::uint64_t i) { return double(i + 1); };
        QCOMPARE(test::filmOf(1, ramp).pixel(0, 0).mean.x, 1.0);
        QCOMPARE(test::filmOf(2, ramp).pixel(0, 0).mean.x, 1.5);
        QCOMPARE(test::filmOf(3, ramp).pixel(0, 0).mean.x, 2.0);
    }

    /// Naive single-precision accumulation is wrong by percents here; the same samples in float show it.
    void meanStaysRightForTenMillionIterations() {
        const auto value = [](std::uint64_t i) { return uniform(i) < 0.9 ? 0.8 : 2.8; };
        const std::uint64_t count = 10'000'000;
        double truth = 0;
        float running = 0, plain = 0;
        for (std::uint64_t i = 0; i < count; ++i) {
            const float sample = float(value(i));
            truth += double(sample);
            plain += sample;
            running += (sample - running) / float(i + 1);
        }
        truth /= double(count);
        const double mean = test::filmOf(count, value).pixel(0, 0).mean.x;
        QVERIFY(std::fabs(mean / truth - 1) < 1e-12);
        QVERIFY(std::fabs(double(running) / truth - 1) > 1e-3);
        QVERIFY(std::fabs(double(plain) / double(count) / truth - 1) > 1e-3);
    }

    void constantSamplesGiveTheConstantAndNoError() {
        const Film film = test::filmOf(100'000, [](std::uint64_t) { return 1.0; });
        QCOMPARE(film.pixel(0, 0).mean.x, 1.0);
        QCOMPARE(film.pixel(0, 0).standardError.x, 0.0);
        QCOMPARE(film.status().relativeError, 0.0);
    }

    void varianceOfSmallNoiseOnALargeValueIsRight() {
        const auto value = [](std::uint64_t i) { return 1e4 + 1e-2 * (2 * uniform(i) - 1); };
        const std::uint64_t count = 100'000;
        test::Sample truth;
        for (std::uint64_t i = 0; i < count; ++i)
            truth.add(float(value(i)));
        const double error = test::filmOf(count, value).pixel(0, 0).standardError.x;
        QVERIFY(std::fabs(error / truth.standardError() - 1) < 1e-3);
    }

    void countGoesOnBeyondFourBillion() {
        Film film(ivec2(1, 1), 0);
        film.commit({(std::uint64_t(1) << 32) - 8, 8});
        QCOMPARE(film.nextSamples(10).first, std::uint64_t(1) << 32);
        QCOMPARE(film.nextSamples(1000).count, kSamplesPerBlock);
    }

    void badSamplesAreLeftOut() {
        const std::pair<float, Fault> bad[] = {{NAN, Fault::notANumber},
                                               {INFINITY, Fault::infinite},
                                               {-INFINITY, Fault::negative},
                                               {-1.0f, Fault::negative}};
        Film film(ivec2(1, 1), 0);
        for (const auto& [value, fault] : bad) {
            QVERIFY(!addSample(*film.sums(test::kOnePixel).pixels, vec3(1, value, 1), 0));
            QVERIFY(faultOf(vec3(1, value, 1)) == fault);
        }
        QVERIFY(addSample(*film.sums(test::kOnePixel).pixels, vec3(3), 4));
        QVERIFY(addSample(*film.sums(test::kOnePixel).pixels, vec3(5), 5));
        film.commit({0, 6});
        QCOMPARE(film.pixel(0, 0).mean.x, 4.0);
        QCOMPARE(film.pixel(0, 0).count, std::uint64_t(2));
    }

    void healthNamesTheFirstSampleOfEachFault() {
        Health one, other;
        one.add(Fault::negative, 7, 3);
        one.add(Fault::negative, 5, 9);
        other.add(Fault::negative, 5, 2);
        other.add(Fault::cutPath, 1, 1);
        Film film(ivec2(4, 4), 0);
        film.sums({0, 0, 4, 4}).health->add(one);
        film.sums({2, 2, 1, 1}).health->add(other);
        const Health health = film.status().health;
        QCOMPARE(health.of(Fault::negative).count, std::uint64_t(3));
        QCOMPARE(health.of(Fault::negative).sample, std::uint64_t(5));
        QCOMPARE(health.of(Fault::negative).pixel, std::uint32_t(2));
        QCOMPARE(health.rejected(), std::uint64_t(3));
        QVERIFY(!health.perfect() && Health().perfect());
    }

    void veryBrightSamplesStayFinite() {
        const Film film = test::filmOf(1000, [](std::uint64_t i) { return i % 2 ? 1e38 : 1e30; });
        QVERIFY(std::isfinite(film.pixel(0, 0).mean.x));
        QVERIFY(std::isfinite(film.pixel(0, 0).standardError.x));
        QVERIFY(std::isfinite(film.status().relativeError));
    }

    void resultDoesNotDependOnIterationsPerFrame() {
        const auto value = [](std::uint64_t i) { return std::exp(5 * uniform(i)); };
        const PixelEstimate one = test::filmOf(1000, value, 1).pixel(0, 0);
        for (const std::uint32_t n : {7u, 10u, 64u}) {
            const PixelEstimate other = test::filmOf(1000, value, n).pixel(0, 0);
            QCOMPARE(other.mean, one.mean);
            QCOMPARE(other.standardError, one.standardError);
        }
    }
};

namespace QTest {
template <>
char* toString(const dvec3& v) {
    return qstrdup(qPrintable(QString("(%1, %2, %3)").arg(v.x).arg(v.y).arg(v.z)));
}
}  // namespace QTest

QTEST_GUILESS_MAIN(FilmTest)
#include "film_test.moc"
