#include <QtTest>

#include <cmath>
#include <limits>

#include "render/film/display/tone_map.h"
#include "render/film/levels.h"

using namespace pdr;

/// The formula of tone_map.h, written out.
static int expected(double radiance, double exposure) {
    const double linear = -std::expm1(-radiance / exposure);
    const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    return int(std::floor(255 * encoded + 0.5));
}

class ToneMapTest : public QObject {
    Q_OBJECT

  private slots:
    void levelsFollowTheFormula() {
        for (const float exposure : {0.01f, 1.0f, 250.0f})
            for (double fraction = 1e-6; fraction < 100; fraction *= 1.001)
                QCOMPARE(int(displayLevel(fraction * exposure, {exposure})), expected(fraction * exposure, exposure));
    }

    void theEndsOfTheScale() {
        QCOMPARE(int(displayLevel(0, {1})), 0);
        QCOMPARE(int(displayLevel(-5, {1})), 0);
        QCOMPARE(int(displayLevel(std::nan(""), {1})), 0);
        QCOMPARE(int(displayLevel(std::numeric_limits<double>::infinity(), {1})), 255);
        QCOMPARE(int(displayLevel(1e300, {1e-30f})), 255);
        QCOMPARE(int(displayLevel(1e-300, {1e30f})), 0);
    }

    void brighterNeverLooksDarker() {
        int last = 0;
        for (double radiance = 1e-5; radiance < 20; radiance *= 1.0005) {
            const int level = displayLevel(radiance, {1});
            QVERIFY(level >= last);
            last = level;
        }
        QCOMPARE(last, 255);
    }

    void aFilmBecomesRgbaFromTheTop() {
        Film film(ivec2(3, 2), 0);
        TileSums sums = film.sums({0, 0, 3, 2});
        for (int i = 0; i < 6; ++i)
            sums.pixels[i] = {.sum = dvec3(i, 2 * i, 0.1), .sumOfSquares = dvec3(0), .count = 1};
        film.commit({0, 1});
        const auto rgba = toneMap(film, {2});
        QCOMPARE(rgba.size(), std::size_t(24));
        for (int i = 0; i < 6; ++i) {
            QCOMPARE(int(rgba[4 * i]), expected(i, 2));
            QCOMPARE(int(rgba[4 * i + 1]), expected(2 * i, 2));
            QCOMPARE(int(rgba[4 * i + 2]), expected(0.1, 2));
            QCOMPARE(int(rgba[4 * i + 3]), 255);
        }
    }
    /// A whole film is shown faster than by a search for each level; at every border it must come to the same.
    void aFilmHasTheLevelsOfTheSearch() {
        std::vector<double> radiances{0, 1e-300, 1e-9, 15.99999, 16, 17, 1e300, HUGE_VAL};
        for (const double threshold : displayThresholds())
            for (const double scale : {1 - 1e-15, 1.0, 1 + 1e-15, 0.999, 1.001})
                radiances.push_back(threshold * scale);
        Film film(ivec2(int(radiances.size()), 1), 0);
        TileSums sums = film.sums({0, 0, film.size().x, 1});
        for (std::size_t i = 0; i < radiances.size(); ++i)
            sums.pixels[i] = {.sum = dvec3(radiances[i]), .sumOfSquares = dvec3(0), .count = 1};
        film.commit({0, 1});
        for (const float exposure : {1.0f, 0.37f, 1e30f, 0.0f}) {
            const auto rgba = toneMap(film, {exposure});
            for (std::size_t i = 0; i < radiances.size(); ++i)
                QCOMPARE(int(rgba[4 * i]), int(displayLevel(film.pixel(int(i), 0).mean.x, {exposure})));
        }
    }
};

QTEST_APPLESS_MAIN(ToneMapTest)
#include "tone_map_test.moc"
