/// Low-discrepancy points: they are those that were published, each coordinate alone is as random as a hashed number,
/// and together they are even.

#include <QTest>
#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <vector>

#include "render/kernel/sampler.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

constexpr double kAlarm = 1e-6;  ///< false-alarm rate of each comparison; seeds are fixed

std::uint32_t coordinate(int dimension, std::uint32_t point) {
    return sobolCoordinate(kSobolTable, dimension, point);
}

Sampler sampler(std::uint32_t pixel, std::uint64_t sample) {
    return {kSobolTable, 5, pixel, sample};
}

float depthOf(std::uint32_t pixel, std::uint64_t sample) {
    return -std::expm1(-sampler(pixel, sample).depth(0));
}

/// Returns whether `points` fractions, a power of two, lie one in each of as many equal intervals.
template <class Fraction>
bool oneInEachInterval(std::uint32_t points, Fraction&& fraction) {
    std::set<std::uint64_t> intervals;
    for (std::uint32_t i = 0; i < points; ++i)
        intervals.insert(std::uint64_t(fraction(i)) * points >> 32);
    return intervals.size() == points;
}

constexpr std::uint64_t kSeeds = 64;
constexpr std::uint32_t kPixels = 4096;

/// One half of a pixel's samples.
struct Sequence {
    std::uint64_t seed, half;
    std::uint32_t pixel;

    Sampler operator[](std::uint64_t i) const { return {kSobolTable, seed, pixel, 2 * i + half}; }
};

/// Returns number(sequence) of all pixels of an image, by its seed and half.
template <class Number>
auto imageOf(std::uint64_t seed, std::uint64_t half, Number&& number) {
    std::vector<decltype(number(Sequence()))> image;
    for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel)
        image.push_back(number(Sequence{seed, half, pixel}));
    return image;
}

/// Returns the error of the mean of five samples for the half of the unit cube below its diagonal plane.
float errorOf(const Sequence& samples) {
    float below = 0;
    for (std::uint64_t i = 0; i < 5; ++i) {
        const vec2 place = samples[i].pair(Dimension::filter);
        below += place.x + place.y + samples[i].number(0, BounceDimension::choice) < 1.5f;
    }
    return below / 5 - 0.5f;
}

/// Returns the correlation of the errors of each pixel in one image with those of the pixel `lag` behind it in another,
/// in units of its own standard error.
double correlation(const std::vector<float>& a, const std::vector<float>& b, std::ptrdiff_t lag) {
    const double product = std::inner_product(a.begin(), a.end() - lag, b.begin() + lag, 0.0);
    const double squares =
        std::inner_product(a.begin(), a.end(), a.begin(), 0.0) * std::inner_product(b.begin(), b.end(), b.begin(), 0.0);
    return product / std::sqrt(squares) * std::sqrt(double(kPixels));
}

}  // namespace

class SamplerTest : public QObject {
    Q_OBJECT

  private slots:
    /// The first points in three dimensions as Joe & Kuo print them, in the order of Gray's code.
    void thePointsAreThosePublished() {
        const double published[10][3] = {{0, 0, 0},
                                         {0.5, 0.5, 0.5},
                                         {0.75, 0.25, 0.25},
                                         {0.25, 0.75, 0.75},
                                         {0.375, 0.375, 0.625},
                                         {0.875, 0.875, 0.125},
                                         {0.625, 0.125, 0.875},
                                         {0.125, 0.625, 0.375},
                                         {0.1875, 0.3125, 0.9375},
                                         {0.6875, 0.8125, 0.4375}};
        for (std::uint32_t i = 0; i < 10; ++i)
            for (int dimension = 0; dimension < 3; ++dimension)
                QCOMPARE(coordinate(dimension, i ^ (i >> 1)) * 0x1p-32, published[i][dimension]);
    }

    /// Checks each coordinate alone, plain and scrambled, in aligned blocks of a power of two of points.
    void everyCoordinateIsEvenInItself() {
        for (int dimension = 0; dimension < kSobolDimensions; ++dimension)
            for (const std::uint32_t points : {2u, 16u, 256u, 4096u})
                for (const std::uint32_t block : {0u, 1u, 77u, 4095u})
                    for (const std::uint32_t seed : {0u, 1u, 0x9E3779B9u}) {
                        const auto plain = [&](std::uint32_t i) { return coordinate(dimension, block * points + i); };
                        QVERIFY(oneInEachInterval(points, plain));
                        QVERIFY(
                            oneInEachInterval(points, [&](std::uint32_t i) { return owenScrambled(plain(i), seed); }));
                    }
    }

    /// The place in the pixel: of 2^m samples of a half, one in each rectangle of area 2^-m, whatever its shape.
    void samplesFillThePixelEvenly() {
        for (const int half : {0, 1})
            for (std::uint32_t pixel = 0; pixel < 20; ++pixel)
                for (int across = 0; across <= 6; ++across) {
                    std::set<std::pair<int, int>> rectangles;
                    for (std::uint64_t i = 0; i < 64; ++i) {
                        const vec2 u = sampler(pixel, 2 * i + std::uint64_t(half)).pair(Dimension::filter);
                        rectangles.insert({int(u.x * float(1 << across)), int(u.y * float(1 << (6 - across)))});
                    }
                    QCOMPARE(rectangles.size(), std::size_t(64));
                }
    }

    /// Over pixels a number of any sample is uniform, and independent of its neighbours' in the sequence, in the other
    /// half and in the other dimension.
    void numbersOfOtherPixelsAreIndependent() {
        const auto board = [](auto&& a, auto&& b) {
            std::array<double, 256> counts{};
            for (std::uint32_t pixel = 0; pixel < 100'000; ++pixel)
                ++counts[int(a(pixel) * 16) * 16 + int(b(pixel) * 16)];
            return test::uniformP(counts);
        };
        for (const std::uint64_t sample : {0ull, 1ull, 5ull, 126ull}) {
            const auto first = [&](std::uint32_t pixel) { return depthOf(pixel, sample); };
            const auto nextPixel = [&](std::uint32_t pixel) { return depthOf(pixel + 1, sample); };
            const auto otherHalf = [&](std::uint32_t pixel) { return depthOf(pixel, sample ^ 1); };
            const auto place = [&](std::uint32_t pixel) { return sampler(pixel, sample).pair(Dimension::filter).x; };
            const auto choice = [&](std::uint32_t pixel) {
                return sampler(pixel, sample).number(0, BounceDimension::choice);
            };
            QVERIFY(board(first, nextPixel) > kAlarm);
            QVERIFY(board(first, otherHalf) > kAlarm);
            QVERIFY(board(first, place) > kAlarm);
            QVERIFY(board(choice, place) > kAlarm);
        }
    }

    /// Seeds that follow each other, pixels and halves have no points in common: 69 bits tell 524,288 sequences apart,
    /// so that one in 10^9 such tests would see two of them meet.
    void noTwoSeedsShareASequence() {
        std::vector<std::array<float, 3>> first;
        for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
            for (const std::uint64_t half : {0, 1})
                for (const auto& point : imageOf(seed, half, [](const Sequence& samples) {
                         const vec2 place = samples[0].pair(Dimension::filter);
                         return std::array{place.x, place.y, samples[0].number(0, BounceDimension::choice)};
                     }))
                    first.push_back(point);
        const std::size_t all = first.size();
        std::ranges::sort(first);
        const auto again = first.end() - std::unique(first.begin(), first.end());
        QVERIFY2(again == 0, qPrintable(QString("%1 of %2").arg(again).arg(all)));
    }

    /// Checks all pairs of 64 consecutive seeds, half by half, pixel by pixel and with the next pixel: the errors of
    /// two images are uncorrelated, so that their mean has half of their variance.
    void errorsOfNeighbouringSeedsAreIndependent() {
        std::vector<std::vector<float>> errors;
        for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
            for (const std::uint64_t half : {0, 1})
                errors.push_back(imageOf(seed, half, errorOf));
        const std::size_t images = errors.size();
        double worst = 0;
        for (std::size_t a = 0; a < images; ++a)
            for (std::size_t b = 0; b < images; ++b)
                for (const std::ptrdiff_t lag : {0, 1})
                    if (lag == 1 || a < b)
                        worst = std::max(worst, std::fabs(correlation(errors[a], errors[b], lag)));
        const double allowed = test::allowedZ(int(images * images + images * (images - 1) / 2), kAlarm);
        QVERIFY2(worst < allowed, qPrintable(QString("%1 standard errors, %2 allowed").arg(worst).arg(allowed)));
    }

    /// The two events of a first segment: one lies in the nearer half of the distribution and one in the further half.
    void eventsShareTheDistribution() {
        for (std::uint64_t sample = 0; sample < 400; ++sample) {
            const float first = sampler(3, sample).depth(0), second = sampler(3, sample).depth(1);
            QVERIFY(first < negativeLog(0.5f) ? second > negativeLog(0.5f) : second < negativeLog(0.5f));
        }
    }

    /// The numbers of the events of one segment are neighbours in a denser sequence, and their hashed numbers differ.
    void branchesAreTheNextPoints() {
        for (std::uint64_t sample = 0; sample < 40; ++sample)
            for (int i = 0; i < 2; ++i) {
                const Sampler branch = sampler(3, sample).branch(i, 2);
                const Sampler dense = sampler(3, 2 * (2 * (sample / 2) + std::uint64_t(i)) + sample % 2);
                QCOMPARE(branch.number(0, BounceDimension::choice), dense.number(0, BounceDimension::choice));
                QCOMPARE(branch.pair(0, BounceDimension::light), dense.pair(0, BounceDimension::light));
            }
        const auto hashed = [](int i) {
            return sampler(3, 1).branch(i, 2).stream(0, BounceDimension::environment).pair().x;
        };
        QVERIFY(hashed(0) != hashed(1));
    }

    /// Depths are exact where they are small and where they are large.
    void depthsAreExponential() {
        for (std::uint64_t fraction = 0; fraction < 0x1'0000'0000; fraction = fraction * 17 / 16 + 1)
            for (const std::uint32_t f : {std::uint32_t(fraction), ~std::uint32_t(fraction)}) {
                const double x = (double(f) + 0.5) * 0x1p-32, truth = -std::log1p(-x);
                const double got = double(freePathDepth(f));
                // Near 1 a float's distance from 1 is what counts; it has 24 bits.
                QVERIFY2(std::fabs(got / truth - 1) < 4e-7,
                         qPrintable(QString("%1: %2 %3").arg(x).arg(got).arg(truth)));
            }
        QVERIFY(freePathDepth(0) > 1e-10f && freePathDepth(~0u) < 23);
    }

    /// After the first event all numbers are hashed: those that Random gives.
    void laterNumbersAreHashed() {
        const Random random(5, 9, 8);
        for (const BounceDimension dimension : {BounceDimension::light, BounceDimension::continuation}) {
            RandomStream stream = random.stream(2, dimension);
            const vec2 pair = stream.pair();
            QCOMPARE(sampler(9, 8).pair(2, dimension), pair);
            QCOMPARE(sampler(9, 8).triple(2, dimension), vec3(pair, stream.pair().x));
            QCOMPARE(sampler(9, 8).number(2, dimension), pair.x);
        }
    }
};

QTEST_GUILESS_MAIN(SamplerTest)
#include "sampler_test.moc"
