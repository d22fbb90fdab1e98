/// Tests how errors of a denoised image are averaged over pixels that look alike, and what they are in levels.

#include <QTest>
#include <cmath>

#include "render/film/error/error_classes.h"
#include "render/film/error/judged_levels.h"
#include "tests/support/scenes/known_films.h"
#include "tests/support/scenes/noisy_films.h"

using namespace pdr;

namespace {

/// Returns an estimate whose mean is `mean`, and which is mostly noise; below 0 as often as not.
vec3 noisy(float mean, int i) {
    return vec3(mean * float(8 * test::chance(1, std::size_t(i), 0) - 3));
}

/// Returns the bin of a pixel among others that are as bright.
LookBin flat(float light) {
    return LookBin::of(light, light, light);
}

/// Adds a pixel whose channels are off together.
void add(ErrorSums& sums, LookBin bin, vec3 squaredErrors) {
    sums.add(bin, squaredErrors, 9 * squaredErrors.x);
}

/// Returns the levels of pixels of one light, whose error in each channel has the variance `variance`.
JudgedLevels levelsOf(float exposure, float light, float variance, float found) {
    JudgedLevels sums(exposure);
    for (int tile = 0; tile < 20; ++tile) {
        for (int i = 0; i < 256; ++i)
            sums.add({i % 16, i / 16}, vec3(light), vec3(variance), vec3(found), 1);
        sums.endTile();
    }
    return sums;
}

}  // namespace

class JudgedLevelsTest : public QObject {
    Q_OBJECT

  private slots:
    void errorsAreThoseOfTheBrightness() {
        ErrorSums sums;
        for (int i = 0; i < 20'000; ++i) {
            const float light = std::exp2(float(i % 4) - 2);
            add(sums, flat(light), noisy(0.01f * light, i));
        }
        const ErrorClasses errors(sums);
        for (int octave = -2; octave < 2; ++octave) {
            const float light = std::exp2(float(octave));
            QVERIFY(std::fabs(errors.variance(flat(1.1f * light)).y / (0.01f * light) - 1) < 0.2f);
        }
        QCOMPARE(ErrorClasses().variance(flat(1)).x, 0.0f);
    }

    void errorsOfEdgesAreTheirOwn() {
        ErrorSums sums;
        const LookBin edge = LookBin::of(1, 0.5f, 2), shade = LookBin::of(1, 0.98f, 1);
        for (int i = 0; i < 1000; ++i)
            add(sums, i % 2 == 0 ? edge : shade, vec3(i % 2 == 0 ? 0.4f : 0.1f));
        QVERIFY(std::fabs(ErrorClasses(sums).variance(edge).x - 0.4f) < 1e-6f);
        QVERIFY(std::fabs(ErrorClasses(sums).variance(shade).x - 0.1f) < 1e-6f);
    }

    /// A mean below 0 is chance: the error may be as large as what chance can hide.
    void errorsThatChanceHidesCount() {
        ErrorSums sums;
        for (int i = 0; i < 100; ++i)
            add(sums, flat(1), vec3(i % 2 == 0 ? 2.0f : -3.0f));
        const float hidden = std::sqrt((4.0f + 9) / 2 / 100);
        QVERIFY(std::fabs(ErrorClasses(sums).variance(flat(1)).x - hidden) < 1e-4f);
    }

    /// A few pixels are no class of their own, at either end.
    void fewPixelsJoinTheirNeighbours() {
        ErrorSums sums;
        for (int i = 0; i < 1000; ++i)
            add(sums, flat(1), vec3(0.5f));
        add(sums, flat(0), vec3(100));
        add(sums, flat(1e6f), vec3(100));
        const ErrorClasses errors(sums);
        for (const float light : {0.0f, 1.0f, 30.0f, 1e9f})
            QVERIFY(std::fabs(errors.variance(flat(light)).z - 0.7f) < 0.01f);
    }

    void nineteenOfTwentyAreWithinTheLevels() {
        constexpr float kExposure = 2, kDeviation = 0.1f;
        for (const float light : {0.05f, 0.6f, 3.0f, 30.0f}) {
            const double said = levelsOf(kExposure, light, kDeviation * kDeviation, 0).levels();
            const int pixels = 100'000;
            int within = 0;
            for (int i = 0; i < pixels; ++i) {
                const double u = test::chance(2, std::size_t(i), 0), v = test::chance(3, std::size_t(i), 0);
                const double normal = std::sqrt(-2 * std::log(1 - u)) * std::cos(6.283185307 * v);
                const double off = test::curve(double(light) + kDeviation * normal, kExposure);
                within += std::fabs(off - test::curve(double(light), kExposure)) <= said + 0.02;
            }
            QVERIFY2(within > 0.93 * pixels && (within < 0.97 * pixels || said < 0.1),
                     qPrintable(QString("%1 within %2").arg(within).arg(said)));
        }
    }

    /// The uncertainty is that of the mean over tiles that are off by chance, and none where they are as expected; what
    /// was fitted to them makes it wider.
    void tilesTellHowUncertainTheVarianceIs() {
        QCOMPARE(levelsOf(1, 0.5f, 0.01f, 0.01f).uncertainty(0), 0.0);
        QVERIFY(std::fabs(levelsOf(1, 0.5f, 0.01f, 0.02f).uncertainty(0) - 1 / std::sqrt(20.0)) < 1e-6);
        const double fitted = levelsOf(1, 0.5f, 0.01f, 0.02f).uncertainty(15);
        QVERIFY(std::fabs(fitted - 2 / std::sqrt(20.0)) < 1e-6);
        QCOMPARE(levelsOf(1, 0.5f, 0, 0).uncertainty(0), 0.0);
        QCOMPARE(levelsOf(1, 0.5f, 0, 0).levels(), 0.0);
    }

    void sumsOfPartsAreTheSumOfAll() {
        JudgedLevels twice = levelsOf(1, 0.5f, 0.01f, 0.02f);
        twice.add(levelsOf(1, 0.5f, 0.01f, 0.02f));
        QCOMPARE(twice.levels(), levelsOf(1, 0.5f, 0.01f, 0.02f).levels());
        QVERIFY(std::fabs(twice.uncertainty(0) - 1 / std::sqrt(40.0)) < 1e-6);
    }
};

QTEST_GUILESS_MAIN(JudgedLevelsTest)
#include "judged_levels_test.moc"
