/// Values as users read them, and HU along a line.

#include <QTest>

#include "render/measure/measure_text.h"
#include "render/measure/profile.h"

using namespace pdr;
using namespace pdr::measure;

namespace {

Stated stated(double value, double grid, double edge = 0, double hand = 0) {
    Stated made{.value = value};
    made.shares = {grid, edge, hand, 0};
    return made;
}

QString said(const Text& text) {
    return QString::fromStdString(text);
}

}  // namespace

class MeasureTextTest : public QObject {
    Q_OBJECT

  private slots:
    void aValueHasTheDigitsOfItsPlusMinus() {
        const std::tuple<double, double, const char*> cases[]{
            {42.31, 0.47, "42.3 ± 0.5 mm"}, {42.31, 0.5, "42.3 ± 0.5 mm"},  {42.31, 0.01, "42.3 ± 0.1 mm"},
            {42.31, 0.14, "42.3 ± 0.2 mm"}, {42.31, 1.23, "42.3 ± 1.3 mm"}, {42.31, 1.0, "42.3 ± 1.0 mm"},
            {42.31, 2.1, "42 ± 3 mm"},      {42.31, 9.4, "42 ± 10 mm"},     {423.1, 12.3, "423 ± 13 mm"},
            {1423.1, 23, "1420 ± 30 mm"},   {0.04, 0.2, "0.0 ± 0.2 mm"},    {-0.04, 0.2, "0.0 ± 0.2 mm"},
        };
        for (const auto& [value, plusMinus, text] : cases)
            QCOMPARE(said(valueText(stated(value, plusMinus), Unit::mm)), QString(text));
    }

    void aBoundIsRoundedToTheSafeSide() {
        const Stated thin = asAtMost(stated(2.1, 0.3), 2.83, Limit::thin);
        QCOMPARE(said(valueText(thin, Unit::mm)), "at most 2.9 mm: thinner than this scan can tell");
        QCOMPARE(said(valueText(asAtMost(stated(2.1, 1), 4.41, Limit::spread), Unit::degrees)), "at most 4.5°");
        QCOMPARE(said(valueText(asAtLeast(stated(178, 1), 176.09, 180, Limit::spread), Unit::degrees)),
                 "at least 176.0°");
    }

    void unitsAreThoseOfTheClinic() {
        QCOMPARE(said(valueText(stated(1234, 50), Unit::mm2)), "1230 ± 50 mm²");
        QCOMPARE(said(valueText(stated(42.34, 2), Unit::degrees)), "42 ± 2°");
        QCOMPARE(said(valueText(stated(42.34, 0), Unit::mm)), "42.3 mm");
    }

    void theTipSaysWhatThePlusMinusConsistsOf() {
        QCOMPARE(said(causesText(stated(42, 0.2, 0.4, 0.2))),
                 "Edges ±0.4, grid ±0.2, hand ±0.2. Not in it: the scanner's own scale, movement, what was meant.");
        QCOMPARE(said(causesText(stated(42, 0))), "Typed places have no ±.");
    }

    void meansOfFewVoxelsHaveNoPlusMinus() {
        QCOMPARE(said(meanText({.count = 1031, .meanHu = 54.96, .meanPlusMinus = 17.2})), "55 ± 18 HU");
        QCOMPARE(said(meanText({.count = 7, .meanHu = 54.96})), "55 HU, too few voxels for a ±");
    }

    void aRegionsTipSaysWhatIsKnown() {
        RegionStatistics ball{
            .count = 1031, .millilitres = 2.079, .medianHu = 27.4, .sdHu = 168.9, .lowestHu = -312, .highestHu = 1038};
        QCOMPARE(said(regionText(ball)), "SD 169 HU, median 27 HU, -312 to 1038 HU, 1031 voxels, 2.08 ml.");
        ball.padding = 7;
        ball.cut = true;
        ball.meanPlusMinus = 17.2;
        QCOMPARE(
            said(regionText(ball)),
            "SD 169 HU, median 27 HU, -312 to 1038 HU, 1031 voxels, 2.08 ml. The scanner measured nothing in 7 more. "
            "The region extends beyond the scan. The ± is that of the noise. Not in it: the scanner's own scale, where "
            "the "
            "region was put.");
    }

    /// The HU of a ramp rise evenly along any line.
    void aProfileOfARampIsStraight() {
        Voxels voxels;
        for (int k = 0; k < 8; ++k)
            for (int j = 0; j < 8; ++j)
                for (int i = 0; i < 8; ++i)
                    voxels.push_back(std::int16_t(10 * i + 30 * k));
        std::vector<bool> padding(512);
        padding[511] = true;
        const Volume ramp(VolumeGeometry::aligned({8, 8, 8}, {1, 1, 2}, dvec3(0)), std::move(voxels), padding);
        const auto samples = profile(ramp, {1, 2, 3}, {5, 2, 9});
        QVERIFY(samples.size() == 9);
        for (const ProfileSample& each : samples) {
            const double share = each.mm / std::sqrt(52.0);
            QVERIFY(std::abs(each.hu - (10 * (1 + 4 * share) + 15 * (3 + 6 * share))) < 1e-9 && each.measured);
        }
        QCOMPARE(samples.back().mm, std::sqrt(52.0));
        QVERIFY(!profile(ramp, {6, 6, 13}, {7, 7, 14}).back().measured);
        QVERIFY(!profile(ramp, {0, 0, 0}, {-3, 0, 0}).back().measured);
        QVERIFY(profile(ramp, {1, 1, 1}, {1, 1, 1}).size() == 2);
    }
};

QTEST_APPLESS_MAIN(MeasureTextTest)
#include "measure_text_test.moc"
