#include <QTest>
#include <cmath>

#include "render/accuracy/prediction.h"
#include "tests/support/scenes.h"

using namespace pdr;

class PredictionTest : public QObject {
    Q_OBJECT

  private slots:
    void halfTheErrorCostsFourTimesTheSamples() {
        const FilmStatus status{.samplesPerPixel = 100, .relativeError = 0.2};
        QCOMPARE(samplesToReach(0.1, status), 400.0);
        QCOMPARE(samplesToReach(0.3, status), 100.0);
    }

    void nextStepIsRounderAndSmaller() {
        const auto step = nextQualityStep({.samplesPerPixel = 100, .displayError = 10.4}, 10);
        QVERIFY(step.has_value());
        QCOMPARE(step->levels, 8.0);
        QCOMPARE(step->seconds, 100 * (1.3 * 1.3 - 1) / 10);
        QVERIFY(!step->atLeast);
        QVERIFY(nextQualityStep({.samplesPerPixel = 100, .displayError = 10.4, .fewBrightSamples = true}, 10)->atLeast);
        QCOMPARE(nextQualityStep({.samplesPerPixel = 100, .displayError = 8}, 10)->levels, 4.0);
        QCOMPARE(nextQualityStep({.samplesPerPixel = 100, .displayError = 200}, 10)->levels, 32.0);
    }

    void nothingIsForetoldWithoutAnErrorOrWithoutSpeed() {
        QVERIFY(!nextQualityStep({.samplesPerPixel = 100, .relativeError = 0.3}, 10));
        QVERIFY(!nextQualityStep({.samplesPerPixel = 100, .displayError = INFINITY}, 10));
        QVERIFY(!nextQualityStep({.samplesPerPixel = 100, .displayError = 10}, 0));
        QVERIFY(!nextQualityStep({.samplesPerPixel = 100, .displayError = 1}, 10));
        QVERIFY(!nextQualityStep({.samplesPerPixel = 100, .displayError = 0}, 10));
    }

    /// What was foretold from 64 samples is reached when they are taken: low-discrepancy points may reach it sooner.
    void forecastComesTrue() {
        Scene scene = test::plainScene(test::bumpyVolume({40, 40, 40}, dvec3(1), 3), 1);
        scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}, {.hu = 600, .opacity = 1}};
        const FilmStatus early = test::render(scene, 64).status();
        const double needed = samplesToReach(early.relativeError / 5, early);
        const FilmStatus late = test::render(scene, std::uint64_t(needed)).status();
        QVERIFY(late.relativeError < 1.03 * early.relativeError / 5);
    }
};

QTEST_GUILESS_MAIN(PredictionTest)
#include "prediction_test.moc"
