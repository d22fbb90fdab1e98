/// Whether forecasts come true: from an image of 64 samples, how many more it takes to errors of 0.6 and 0.35 of its
/// own, scene by scene over seeds. There are few seeds here; PDR_COVERAGE_SEEDS=40 takes as many, from 256 samples as
/// well, and prints the results (with QTEST_FUNCTION_TIMEOUT=3600000: it takes longer than tests may). From 64 samples
/// the exponent of a scene is little known; over all scenes it is right.

#include <QTest>
#include <cmath>

#include "app/bench/median.h"
#include "app/bench/prediction/coverage.h"
#include "tests/support/scenes/coverage_scenes.h"

using namespace pdr;
using test::MakeScene;

namespace {

constexpr float kExposure = 0.5f;

}  // namespace

class ForecastCoverageTest : public QObject {
    Q_OBJECT

  private slots:
    void forecastsComeTrue_data() {
        QTest::addColumn<MakeScene>("made");
        QTest::newRow("tissue") << MakeScene(test::tissueScene);
        QTest::newRow("lens") << MakeScene(test::tissueThroughALens);
        QTest::newRow("forward fog") << MakeScene(test::forwardFog);
        QTest::newRow("small bright lamp") << MakeScene(test::smallBrightLamp);
        QTest::newRow("many bounces") << MakeScene(test::manyBounces);
    }
    void forecastsComeTrue() {
        QFETCH(MakeScene, made);
        const int asked = qEnvironmentVariableIntValue("PDR_COVERAGE_SEEDS"), seeds = std::max(asked, 20);
        Scene scene = made();
        scene.film = {28, 22};
        std::vector<bench::Prediction> predictions{{64, 0.6}, {64, 0.35}};
        if (asked > 0)
            predictions.insert(predictions.end(), {{256, 0.6}, {256, 0.35}});
        const auto tallies = bench::talliesOf(scene, predictions, seeds, kExposure, *device_);
        QVERIFY(bool(tallies));
        for (std::size_t i = 0; i < predictions.size(); ++i) {
            const bench::PredictionTally& tally = (*tallies)[i];
            const double median = bench::median(tally.ratios);
            qInfo(
                "from %d samples to %.2f of the error: %d of %d inside, %d not before, %d said at least, "
                "foretold / needed %.2f in the median",
                int(predictions[i].samples), predictions[i].part, tally.within, seeds, tally.notBefore, tally.atLeast,
                median);
            QVERIFY(tally.notBefore >= 0.9 * seeds);
            if (tally.atLeast > seeds / 2)
                continue;
            // At 95 %, this fails by chance once in 1,000 scenes. Ten seeds scatter the median of the small bright lamp,
            // 1.25 of 60 seeds, up to 1.5. 256 samples are the worst place for a forecast: there the points dip, for all
            // seeds alike.
            QVERIFY(tally.within >= (asked > 0 ? 0.8 : 0.7) * seeds);
            QVERIFY(median > 0.66 && median < 1.5);
            ratios_.insert(ratios_.end(), tally.ratios.begin(), tally.ratios.end());
        }
    }
    void ofAllScenesTheMedianIsRight() {
        const double median = bench::median(ratios_);
        QVERIFY2(std::fabs(median - 1) < 0.1, qPrintable(QString::number(median)));
    }

  private:
    std::unique_ptr<Device> device_ = makeCpuDevice();
    std::vector<double> ratios_;  ///< ratios of all forecasts that did not say "at least"
};

QTEST_GUILESS_MAIN(ForecastCoverageTest)
#include "forecast_coverage_test.moc"
