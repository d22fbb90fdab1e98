/// What is read off measured curves of accuracy against time.

#include "tests/support/tissue_scene.h"  // before Qt, whose word "emit" TBB uses

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>

#include "app/cli/accuracy/accuracy_page.h"

using namespace pdr;
using namespace pdr::app;

namespace {

/// levels = high seconds^-slope, at least `floor`, at 1, 2, 4, ... 64 samples of 0.1 s.
AccuracyCurve curveOf(double high, double slope, double floor = 0) {
    AccuracyCurve curve{"a way", floor > 0 ? "a bias" : "", {}};
    for (std::uint64_t samples = 1; samples <= 64; samples *= 2) {
        const double seconds = 0.1 * double(samples);
        curve.steps.push_back({samples, seconds, {0.1, std::max(floor, high * std::pow(seconds, -slope))}, {}, {}, {}});
    }
    return curve;
}

bool near(std::optional<double> is, double expected) {
    return is && std::fabs(*is / expected - 1) < 1e-9;
}

}  // namespace

class AccuracyCurveTest : public QObject {
    Q_OBJECT

  private slots:
    void betweenStepsTheTimeFollowsThePowerLaw() {
        const AccuracyCurve curve = curveOf(20, 0.5);
        QVERIFY(near(secondsToReach(20, curve), 1));
        QVERIFY(near(secondsToReach(10, curve), 4));
        QVERIFY(near(secondsToReach(20 / std::sqrt(3.3), curve), 3.3));
        QVERIFY(near(secondsToReach(200, curve), 0.1));  // the first step has it
        QVERIFY(!secondsToReach(7, curve));
        QVERIFY(!secondsToReach(1, {}));
    }
    /// What is better by luck for a moment is not reached.
    void onlyWhatLastsIsReached() {
        AccuracyCurve curve = curveOf(20, 0.5);
        curve.steps[1].error.levels = 1;
        QVERIFY(near(secondsToReach(10, curve), 4));
    }
    void blurIsTheBetterPictureUntilItsBiasShows() {
        const AccuracyCurve unbiased = curveOf(20, 0.5), blurred = curveOf(10, 0.5, 12);
        const auto until = betterUntil(blurred, unbiased);
        QVERIFY(until && std::fabs(*until / (100.0 / 36) - 1) < 0.05);  // 20 / sqrt(t) = 12
        QVERIFY(std::isinf(*betterUntil(curveOf(10, 0.5, 1), unbiased)));
        QVERIFY(!betterUntil(curveOf(30, 0.5, 12), unbiased));
        QVERIFY(!betterUntil({}, unbiased));
    }
    void theLadderNamesWhatWasReached() {
        QCOMPARE(QString::fromStdString(ladderText(curveOf(16, 0.5))), QString("±32 in 0.25 s, ±16 in 1 s, ±8 in 4 s"));
        QCOMPARE(QString::fromStdString(ladderText(curveOf(1000, 0.1))), QString("not yet within ±32"));
    }
    void aSceneIsAlsoMadeAsExposureRenderMakesIt() {
        const auto ways = accuracyWays(test::tissueScene());
        QCOMPARE(ways.size(), std::size_t(3));
        QVERIFY(ways[0].bias.empty() && !ways[1].bias.empty() && !ways[2].bias.empty());
        Scene bounces = test::tissueScene();
        bounces.model = Model::multipleScattering;
        QCOMPARE(accuracyWays(bounces).size(), std::size_t(2));  // the march knows one event alone
    }
    void tableAndPageHoldTheSteps() {
        AccuracyReport report;
        report.curves = {curveOf(20, 0.5), curveOf(10, 0.5, 12)};
        report.curves[0].steps[3].stated = 9;
        const QString csv = QString::fromStdString(csvText(report));
        QCOMPARE(csv.count('\n'), 15);
        QVERIFY(csv.contains("\"a way\",8,0.8,0.1,22.3607,9,\n"));
        const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(jsonText(report))).object();
        const QJsonObject way = json["ways"].toArray()[0].toObject();
        QCOMPARE(way["steps"].toArray().size(), 7);
        QVERIFY(std::fabs(way["secondsTo"].toObject()["16"].toDouble() - 1.5625) < 1e-9);
        QVERIFY(way["secondsTo"].toObject()["1"].isNull());
        const QString page = QString::fromStdString(pageText(report, {}));
        QVERIFY(page.contains("<svg") && page.contains("never after"));
        QVERIFY(!page.contains("nan") && !page.contains("inf"));
    }
};

QTEST_GUILESS_MAIN(AccuracyCurveTest)
#include "accuracy_curve_test.moc"
