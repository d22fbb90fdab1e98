/// Tests the tone curve keepsHue: its formula, its greys, and the hues of tissue from dark to bright.

#include <QTest>
#include <cmath>
#include <limits>
#include <random>

#include "render/base/srgb.h"
#include "render/film/display_transform.h"
#include "tests/support/scenes/known_films.h"

using namespace pdr;

namespace {

constexpr float kExposure = 0.7f;
constexpr Tone kKeepsHue{kExposure, ToneCurve::keepsHue}, kPerChannel{kExposure, ToneCurve::perChannel};

/// The formula of tone_curve.h, written out; `light` is in units of the exposure.
dvec3 expected(dvec3 light) {
    const double p = std::max({light.x, light.y, light.z}), n = 1 - std::exp(-p);
    const double g = 1 - 1 / (1 + 0.12 * (p - n));
    dvec3 levels;
    for (int c = 0; c < 3; ++c)
        levels[c] = p > 0 ? 255 * srgbFromLinear(n * ((1 - g) * light[c] / p + g)) : 0;
    return levels;
}

/// Returns random colours from far below black to far above white, some of whose channels are equal or 0.
std::vector<dvec3> colours(int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<dvec3> all;
    for (int i = 0; i < count; ++i) {
        dvec3 light = std::exp2(20 * unit(random) - 13) * dvec3(unit(random), unit(random), unit(random));
        if (i % 7 == 0)
            light[i % 3] = 0;
        if (i % 5 == 0)
            light[i % 3] = light[(i + 1) % 3];
        all.push_back(light);
    }
    return all;
}

/// Returns the hue of an image's colour [degrees] in Oklab (Ottosson 2020).
double hueOf(dvec3 levels) {
    const dvec3 light(linearFromSrgb(levels.x / 255), linearFromSrgb(levels.y / 255), linearFromSrgb(levels.z / 255));
    const double l = std::cbrt(glm::dot(light, dvec3(0.4122214708, 0.5363325363, 0.0514459929)));
    const double m = std::cbrt(glm::dot(light, dvec3(0.2119034982, 0.6806995451, 0.1073969566)));
    const double s = std::cbrt(glm::dot(light, dvec3(0.0883024619, 0.2817188376, 0.6299787005)));
    const double a = 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s;
    const double b = 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s;
    return std::atan2(b, a) * 180 / 3.141592653589793;
}

/// Returns by how many degrees the hue of `colour`, whose largest channel is 1, turns at most from 0.1 to 8 times the
/// exposure.
double mostTurned(dvec3 colour, const Tone& tone) {
    const DisplayTransform transform = displayTransform(tone);
    const dvec3 dark = 255.0 * dvec3(srgbFromLinear(0.02 * colour.x), srgbFromLinear(0.02 * colour.y),
                                     srgbFromLinear(0.02 * colour.z));
    double most = 0;
    for (double light = 0.1; light <= 8; light *= 1.05) {
        const double turned = hueOf(dvec3(transform.exactLevels(light * kExposure * colour))) - hueOf(dark);
        most = std::max(most, std::fabs(std::remainder(turned, 360)));
    }
    return most;
}

std::array<int, 3> bytesOf(dvec3 radiance, const Tone& tone) {
    std::uint8_t levels[3];
    displayTransform(tone).setLevels(radiance, levels);
    return {levels[0], levels[1], levels[2]};
}

}  // namespace

class HueTest : public QObject {
    Q_OBJECT

  private slots:
    void levelsFollowTheFormula() {
        const DisplayTransform transform = displayTransform(kKeepsHue);
        for (const dvec3 light : colours(100'000)) {
            const dvec3 exact(transform.exactLevels(light * double(kExposure))), formula = expected(light);
            const std::array<int, 3> bytes = bytesOf(light * double(kExposure), kKeepsHue);
            for (int c = 0; c < 3; ++c) {
                QVERIFY2(std::fabs(exact[c] - formula[c]) < 0.01, qPrintable(QString::number(exact[c] - formula[c])));
                QVERIFY(std::fabs(bytes[std::size_t(c)] - formula[c]) <= 0.51);
            }
        }
    }

    /// The looks that show greys keep their brightness to the last bit.
    void greysAreThoseOfTheOtherCurve() {
        std::vector<double> greys{0, -1, 1e-300, 1e-9, 15.99999, 16, 1e6, 2e6, 1e300, HUGE_VAL};
        for (const double threshold : displayThresholds())
            for (const double scale : {1 - 1e-15, 1.0, 1 + 1e-15, 0.999, 1.001})
                greys.push_back(threshold * scale * double(kExposure));
        const DisplayTransform keeps = displayTransform(kKeepsHue), each = displayTransform(kPerChannel);
        for (const double grey : greys) {
            QVERIFY(bytesOf(dvec3(grey), kKeepsHue) == bytesOf(dvec3(grey), kPerChannel));
            QVERIFY(keeps.exactLevels(dvec3(grey)) == each.exactLevels(dvec3(grey)));
        }
    }

    void huesStayFromDarkToBright_data() {
        QTest::addColumn<dvec3>("colour");
        QTest::newRow("ivory") << dvec3(1, 0.69, 0.36);
        QTest::newRow("dark ivory") << dvec3(1, 0.67, 0.34);
        QTest::newRow("skin") << dvec3(1, 0.6, 0.41);
        QTest::newRow("fat") << dvec3(1, 0.79, 0.37);
        QTest::newRow("lung") << dvec3(1, 0.67, 0.61);
        QTest::newRow("muscle") << dvec3(1, 0.12, 0.08);
        QTest::newRow("blood") << dvec3(1, 0.072, 0.054);
        QTest::newRow("vein") << dvec3(0.2, 0.3, 1);
        QTest::newRow("gall") << dvec3(0.4, 1, 0.3);
    }
    void huesStayFromDarkToBright() {
        QFETCH(dvec3, colour);
        const double turned = mostTurned(colour, kKeepsHue);
        QVERIFY2(turned < 8, qPrintable(QString::number(turned)));
    }
    void theOtherCurveTurnsThem() {
        QVERIFY(mostTurned({1, 0.69, 0.36}, kPerChannel) > 25);  // ivory over yellow to white
        QVERIFY(mostTurned({1, 0.6, 0.41}, kPerChannel) > 35);
    }

    /// At 8 times the exposure the other curve shows three channels of skin at 255: nothing is left to see there.
    void nothingIsClipped() {
        const dvec3 bright(8 * double(kExposure) * dvec3(1, 0.6, 0.41));
        const std::array<int, 3> kept = bytesOf(bright, kKeepsHue), lost = bytesOf(bright, kPerChannel);
        QVERIFY(lost[1] >= 254 && kept[1] < 240 && kept[2] < kept[1] - 5);
        const DisplayTransform transform = displayTransform(kKeepsHue);
        for (const dvec3 light : colours(20'000)) {
            const vec3 levels = transform.exactLevels(light * double(kExposure));
            const double largest = std::max({light.x, light.y, light.z});
            for (int c = 0; c < 3; ++c)
                QVERIFY(double(levels[c]) <= double(exactLevelOf(displayCurve(), float(largest))) + 1e-9);
        }
    }

    void brighterNeverLooksDarker() {
        const DisplayTransform transform = displayTransform(kKeepsHue);
        for (const dvec3 colour : colours(200)) {
            vec3 last(0.0f);
            for (double light = 1e-3; light < 1e9; light *= 1.03) {
                const vec3 levels = transform.exactLevels(light * colour);
                for (int c = 0; c < 3; ++c)
                    QVERIFY2(levels[c] >= last[c] - 0.005f, qPrintable(QString::number(levels[c] - last[c])));
                last = levels;
            }
        }
    }

    /// What bounds on the largest channel rest on: its level is off by no more than the curve makes of the largest
    /// error of any channel.
    void theLargestChannelKnowsNoOther() {
        const DisplayTransform transform = displayTransform(kKeepsHue);
        const auto largest = [](auto light) { return std::max({light.x, light.y, light.z}); };
        const std::vector<dvec3> all = colours(20'000);
        for (std::size_t i = 1; i < all.size(); ++i) {
            const vec3 a(all[i - 1]), b(all[i]);
            const float apart = std::fabs(largest(transform.exactLevels(a)) - largest(transform.exactLevels(b)));
            QVERIFY(largest(transform.exactLevels(a)) == exactLevelOf(displayCurve(), largest(a)));
            const float off = largest(glm::abs(a - b)), least = std::min(largest(a), largest(b));
            QVERIFY(apart <= exactLevelOf(displayCurve(), least + off) - exactLevelOf(displayCurve(), least) + 1e-3f);
        }
    }

    void theEndsOfTheScale() {
        constexpr double kInfinite = std::numeric_limits<double>::infinity();
        QVERIFY((bytesOf({0, 0, 0}, kKeepsHue) == std::array{0, 0, 0}));
        QVERIFY((bytesOf({-1, -0.5, -1}, kKeepsHue) == std::array{0, 0, 0}));
        QVERIFY((bytesOf({kInfinite, 0, 0}, kKeepsHue) == std::array{255, 255, 255}));
        QVERIFY((bytesOf({1e30, 1, 0}, kKeepsHue) == std::array{255, 255, 255}));
        QVERIFY((bytesOf({1e-30, 0, 0}, kKeepsHue) == std::array{0, 0, 0}));
        QVERIFY(bytesOf({0.3, -0.2, 0.1}, kKeepsHue) == bytesOf({0.3, 0, 0.1}, kKeepsHue));
    }

    /// The film's way to the screen, on the CPU and through a GPU's programs.
    void everyDeviceShowsTheSame() {
        const std::vector<dvec3> all = colours(4'000);
        Film film(ivec2(int(all.size()), 1), 1);
        TileSums sums = film.sums(wholeImage(film.size()));
        for (std::size_t i = 0; i < all.size(); ++i)
            sums.pixels[i] = {.sum = all[i], .sumOfSquares = dvec3(0), .count = 1, .seen = kSeenTissue};
        film.commit({0, 1});
        const Display display{.exposure = kExposure, .curve = ToneCurve::keepsHue};
        const Image here = imageOf(film, display);
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                QCOMPARE(int(here.rgba[4 * i + c]), bytesOf(film.pixel(int(i), 0).mean, kKeepsHue)[c]);
        const auto device = makeEmulatedGpu();
        const auto live = *device->film(film.size(), 1, {});
        QVERIFY(live->resume(film) && live->resolve(display));
        const Result<Image> there = live->readback();
        QVERIFY(there && there->rgba == here.rgba);
        QVERIFY(toneMap(film, {.exposure = kExposure}) != here.rgba);
    }
};

QTEST_GUILESS_MAIN(HueTest)
#include "hue_test.moc"
