/// Tests the error map against films whose error is known.

#include "render/film/error/level_error_map.h"

#include <QTest>
#include <cmath>

#include "render/film/error/likely_error.h"
#include "tests/support/scenes/noisy_films.h"

using namespace pdr;
using namespace pdr::test;

namespace {

constexpr std::uint32_t kSamples = 100;
constexpr float kExposure = 2;

/// Returns a row of equal pixels: their standard error is `presumed`, the draw of their error `real`.
Film rowOf(double mean, double real, double presumed, int pixels = 40) {
    return knownFilm(std::vector<Known>(std::size_t(pixels), {mean, real, presumed * std::sqrt(kSamples - 1.0)}),
                     kSamples);
}

/// Returns the levels within which 95 % of the displayed values lie, for a standard error of `error`.
double interval(double mean, double error) {
    const auto off = [&](double draw) { return std::fabs(curve(mean + draw, kExposure) - curve(mean, kExposure)); };
    return std::max(off(1.96 * error), off(-1.96 * error));
}

bool same(const denoise::Colours& whole, const denoise::Colours& part, const Tile& tile) {
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < tile.height; ++y)
            if (!std::equal(part[c].row(y), part[c].row(y) + tile.width, whole[c].row(tile.y + y) + tile.x))
                return false;
    return part[0].size() == ivec2(tile.width, tile.height);
}

}  // namespace

class LevelErrorMapTest : public QObject {
    Q_OBJECT

  private slots:
    void aKnownErrorIsStatedInLevels_data() {
        QTest::addColumn<double>("mean");
        QTest::addColumn<double>("error");
        QTest::newRow("bright") << 1.5 << 0.1;
        QTest::newRow("dim") << 0.05 << 0.01;
        QTest::newRow("to black and beyond") << 0.02 << 0.012;
        QTest::newRow("near white") << 12.0 << 0.5;
    }
    void aKnownErrorIsStatedInLevels() {
        QFETCH(double, mean);
        QFETCH(double, error);
        const double truth = interval(mean, error);
        QVERIFY(std::fabs(double(levelsWithin(dvec3(mean), dvec3(error), kExposure)) - truth) < 0.02);
        QVERIFY(std::fabs(double(levelsWithin({0, mean, 0}, {0, error, 0}, kExposure)) - truth) < 0.02);
        for (const std::uint8_t bin : levelErrorMap(rowOf(mean, error, error), kExposure).bins)
            QCOMPARE(bin, levelBinOf(float(truth)));
    }

    void theHalvesTellHowMuchBetterThePointsAreThanIndependentOnes() {
        for (const std::uint8_t bin : levelErrorMap(rowOf(1, 0.03, 0.1), kExposure).bins)
            QCOMPARE(bin, levelBinOf(float(interval(1, 0.03))));
        for (const std::uint8_t bin : levelErrorMap(rowOf(1, 0.2, 0.1), kExposure).bins)  // chance: never worse
            QCOMPARE(bin, levelBinOf(float(interval(1, 0.1))));
    }

    void whereThereIsNoTissueThereIsNothing() {
        std::vector<Known> pixels(40, {1, 0.1, 1});
        for (std::size_t i = 0; i < 20; ++i)
            pixels[i].seen = kSeenChance;
        const LevelErrorMap map = levelErrorMap(knownFilm(pixels, kSamples), kExposure);
        QVERIFY(map.size == ivec2(40, 1));
        for (std::size_t i = 0; i < 40; ++i)
            QCOMPARE(map.bins[i] == kNoTissueBin, i < 20);
    }

    void whatIsNotKnownIsNotStated() {
        const auto allUnknown = [](const Film& film) {
            const LevelErrorMap map = levelErrorMap(film, kExposure);
            return std::all_of(map.bins.begin(), map.bins.end(), [](auto bin) { return bin == kUnknownBin; });
        };
        QVERIFY(allUnknown(rowOf(0, 0, 0)));      // unlit
        QVERIFY(allUnknown(rowOf(0.1, 0.5, 9)));  // less than two bright samples in all the pixels around
        QVERIFY(!allUnknown(rowOf(0.1, 0.01, 0.01)));
        const std::vector<Known> pixels(40, {1, 0.1, 1});
        QVERIFY(allUnknown(knownFilm(pixels, kSamplesToEstimate - 2)));
        QVERIFY(!allUnknown(knownFilm(pixels, kSamplesToEstimate)));
        QVERIFY(std::isinf(levelsWithin(dvec3(1), {0, 0, INFINITY}, kExposure)));
    }

    /// A box was sampled first: beside it are pixels of one sample, which know nothing of the noise.
    void besidePixelsOfOneSampleTheBoundStands() {
        FilmContent content = rowOf(1, 0.03, 0.1).content();
        for (std::size_t i = 20; i < 40; ++i)
            content.moments[i] = {.mean = dvec3(1), .count = 1, .evenMean = vec3(1), .evenCount = 1};
        const Film film(1, std::move(content));
        QVERIFY(std::fabs(double(levelErrorsAt(film, {17, 0}, 1, kExposure).here) - interval(1, 0.1)) < 0.02);
        QVERIFY(std::fabs(double(levelErrorsAt(film, {5, 0}, 1, kExposure).here) - interval(1, 0.03)) < 0.02);
    }

    void whatChanceHasNoPartInIsExact() {
        std::vector<Known> pixels(40, {0.5, 0, 0, kSeenTissue});
        for (const std::uint8_t bin : levelErrorMap(knownFilm(pixels, kSamples), kExposure).bins)
            QCOMPARE(bin, kFirstBin);
    }

    /// The row is one pixel high: four pixels of the square are in it.
    void overASquareTheErrorsOfItsPixelsAverageOut() {
        const LevelErrorsAt found = levelErrorsAt(rowOf(1, 0.1, 0.1), {20, 0}, 4, kExposure);
        QVERIFY(found.tissue && found.side == 4);
        QVERIFY(std::fabs(double(found.here) - interval(1, 0.1)) < 0.02);
        QVERIFY(std::fabs(double(found.over) - interval(1, 0.05)) < 0.02);
        const LevelErrorsAt atTheEdge = levelErrorsAt(rowOf(1, 0.1, 0.1), {0, 0}, 4, kExposure);
        QVERIFY(std::fabs(double(atTheEdge.over) - interval(1, 0.1 / std::sqrt(3))) < 0.02);
        const LevelErrorsAt alone = levelErrorsAt(rowOf(1, 0.1, 0.1), {7, 0}, 1, kExposure);
        QCOMPARE(alone.here, alone.over);
    }

    void aSquareWithAPixelThatIsNotKnownIsNotKnown() {
        std::vector<Known> pixels(40, {1, 0.1, 1});
        for (std::size_t i = 20; i < 40; ++i)
            pixels[i] = {0, 0, 0, i < 30 ? kSeenTissue | kSeenChance : 0};
        const Film film = knownFilm(pixels, kSamples);
        const LevelErrorsAt known = levelErrorsAt(film, {19, 0}, 9, kExposure);
        QVERIFY(std::isfinite(known.here) && std::isinf(known.over));
        QVERIFY(std::isinf(levelErrorsAt(film, {25, 0}, 1, kExposure).here));
        QVERIFY(!levelErrorsAt(film, {35, 0}, 1, kExposure).tissue);
    }

    /// Tolerances are four standard errors for 18,000 pixels and 1,900 squares.
    void theIntervalsHoldTheTruth() {
        const ivec2 size(160, 120);
        const auto truth = [](int x, int y) { return 0.1 + 0.02 * (x / 40) + 0.1 * (y / 60); };
        const Film film = noisyFilmOf(size, truth, 64);
        double all = 0, own = 0, squares = 0;
        for (int y = 1; y < size.y - 1; y += 3)
            for (int x = 1; x < size.x - 1; x += 3) {
                const LevelErrorsAt found = levelErrorsAt(film, {x, y}, 3, kExposure);
                double mean = 0, light = 0;
                for (int i = 0; i < 9; ++i) {
                    mean += film.pixel(x - 1 + i % 3, y - 1 + i / 3).mean.y / 9;
                    light += truth(x - 1 + i % 3, y - 1 + i / 3) / 9;
                }
                const auto off = [](double a, double b) {
                    return std::fabs(curve(a, kExposure) - curve(b, kExposure));
                };
                own += off(film.pixel(x, y).mean.y, truth(x, y)) <= double(found.here);
                squares += off(mean, light) <= double(found.over);
                ++all;
            }
        const double allowed = 4 * std::sqrt(0.95 * 0.05 / all);
        QVERIFY2(own / all > 0.95 - allowed && own / all < 0.98 + allowed, qPrintable(QString::number(own / all)));
        QVERIFY2(std::fabs(squares / all - 0.96) < 0.02 + allowed, qPrintable(QString::number(squares / all)));
    }

    /// A bin is 1.7 % wide.
    void binsAreEvenOnALogarithmicScale() {
        QCOMPARE(levelBinOf(0), kFirstBin);
        QCOMPARE(levelBinOf(1), kFirstBin);
        QCOMPARE(int(levelBinOf(2)), kFirstBin + kBinsPerDoubling);
        QCOMPARE(levelBinOf(64), kLastBin);
        QCOMPARE(levelBinOf(255), kLastBin);
        QCOMPARE(levelBinOf(INFINITY), kUnknownBin);
        QCOMPARE(levelsOfBin(kLastBin), kCoarsestLevels);
        for (float levels = 1; levels < 64; levels *= 1.003f)
            QVERIFY(std::fabs(std::log2(levelsOfBin(levelBinOf(levels)) / double(levels))) < 0.501 / kBinsPerDoubling);
    }

    void aPartSaysWhatTheWholeSaysToTheBit() {
        const Film film = noisyFilmOf(
            {61, 47}, [](int x, int y) { return x * y % 7 == 0 ? 3.0 : 0.1 * (1 + x % 5); }, 40);
        const denoise::Colours likely = likelyErrors(film, wholeImage(film.size()));
        for (const Tile& part : {Tile{0, 0, 5, 3}, Tile{20, 17, 30, 20}, Tile{60, 46, 1, 1}, Tile{1, 30, 60, 17}})
            QVERIFY(same(likely, likelyErrors(film, part), part));
    }
};

QTEST_GUILESS_MAIN(LevelErrorMapTest)
#include "level_error_map_test.moc"
