/// Curves and their edits: every edit keeps the order, and what is not edited stays.

#include <QTest>
#include <algorithm>
#include <random>

#include "render/scene/edit/curve_shapes.h"

using namespace pdr;

namespace {

bool isOrdered(const Curve& curve) {
    return std::ranges::is_sorted(curve, {}, &CurvePoint::hu) &&
           std::ranges::all_of(curve, [](const CurvePoint& point) {
               return point.hu >= kLowestHu && point.hu <= kHighestHu && point.value >= 0 && point.value <= 1;
           });
}

const Curve kCurve{{-100, 0}, {0, 0.2f}, {0, 0.5f}, {200, 1}, {400, 0.3f}};

}  // namespace

class CurveTest : public QObject {
    Q_OBJECT

  private slots:
    void atAStepTheRightPointHolds() {
        QCOMPARE(valueAt(kCurve, 0), 0.5f);
        QCOMPARE(valueAt(kCurve, -50), 0.1f);
        QCOMPARE(valueAt(kCurve, 100), 0.75f);
        QCOMPARE(valueAt(kCurve, -5000), 0.0f);
        QCOMPARE(valueAt(kCurve, 5000), 0.3f);
    }

    void aNewPointStandsBehindThoseOfItsHu() {
        Curve curve = kCurve;
        QCOMPARE(insertPoint(curve, {0, 0.9f}), std::size_t(3));
        QCOMPARE(curve[3].value, 0.9f);
        QCOMPARE(insertPoint(curve, {-3000, 0}), std::size_t(0));
        QCOMPARE(insertPoint(curve, {3000, 0}), std::size_t(7));
        QVERIFY(isOrdered(curve));
    }

    void pointsStopAtThoseThatStay() {
        QCOMPARE(moved(kCurve, {3}, {1000, 0}, 1)[3].hu, 400.0f);
        QCOMPARE(moved(kCurve, {3}, {-1000, 0}, 1)[3].hu, 0.0f);
        QCOMPARE(moved(kCurve, {0}, {-1e9f, 0}, 1)[0].hu, kLowestHu);
        QCOMPARE(moved(kCurve, {4}, {1e9f, 0}, 1)[4].hu, kHighestHu);
        QCOMPARE(moved(kCurve, {2}, {-50, 0}, 1)[2].hu, 0.0f);  // the left-hand point of its step stands there
    }

    void severalMoveAsOne() {
        const Curve curve = moved(kCurve, {1, 2}, {500, 0.1f}, 1);
        QCOMPARE(curve[1].hu, 200.0f);
        QCOMPARE(curve[2].hu, 200.0f);
        QCOMPARE(curve[1].value, 0.2f + 0.1f);
        const Curve apart = moved(kCurve, {0, 3}, {-300, 0}, 1);
        QCOMPARE(apart[0].hu, -300.0f);
        QCOMPARE(apart[3].hu, 0.0f);
    }

    void valuesStayInTheirRange() {
        QCOMPARE(moved(kCurve, {3, 4}, {0, 0.5f}, 1)[3].value, 1.0f);
        QCOMPARE(moved(kCurve, {3, 4}, {0, 0.5f}, 1)[4].value, 0.8f);
        QCOMPARE(moved(kCurve, {1}, {0, -7}, 1)[1].value, 0.0f);
    }

    void onePointRemains() {
        QVERIFY((without(kCurve, {1, 3}) == Curve{{-100, 0}, {0, 0.5f}, {400, 0.3f}}));
        QVERIFY((without(kCurve, {0, 1, 2, 3, 4}) == Curve{{-100, 0}}));
    }

    /// Random moves of any points, also of points of equal hu and points at the ends of the scale.
    void noEditBreaksTheOrder() {
        std::mt19937 random(11);
        const auto number = [&](double low, double high) {
            return float(std::uniform_real_distribution<double>(low, high)(random));
        };
        for (int trial = 0; trial < 3000; ++trial) {
            Curve curve{{number(-32768, 32767), 0.5f}};
            for (int i = 0; i < 8; ++i)
                insertPoint(curve, {i % 3 == 0 ? curve[0].hu : std::round(number(-32768, 32767)), number(0, 1)});
            CurveSelection selection;
            for (std::size_t i = 0; i < curve.size(); ++i)
                if (number(0, 1) < 0.4f)
                    selection.push_back(i);
            const Curve edited = moved(curve, selection, {number(-70000, 70000), number(-2, 2)}, 1);
            QVERIFY(isOrdered(edited));
            for (std::size_t i = 0; i < curve.size(); ++i)
                if (!std::ranges::binary_search(selection, i))
                    QVERIFY(edited[i] == curve[i]);
        }
    }

    void theLargerOfTwoIsLargerEverywhere() {
        const Curve bell = bellCurve(150, 120, 0.9f), both = larger(kCurve, bell);
        QVERIFY(isOrdered(both));
        for (float hu = -500; hu < 900; hu += 0.37f)
            QVERIFY(std::fabs(valueAt(both, hu) - std::max(valueAt(kCurve, hu), valueAt(bell, hu))) < 2e-5f);
        QVERIFY(valueAt(both, 0) == 0.5f && valueAt(both, -0.001f) < 0.3f);
    }

    void whereACurveComesTo() {
        QCOMPARE(firstAt(kCurve, 0.1f), -50.0f);
        QCOMPARE(firstAt(kCurve, 0.5f), 0.0f);
        QCOMPARE(firstAt(kCurve, 0.75f), 100.0f);
        QCOMPARE(firstAt(kCurve, 2), 400.0f);
        QCOMPARE(firstAt(kCurve, 0), -100.0f);
        QCOMPARE(heightOf(kCurve), 1.0f);
    }

    void shapesAreWhatTheirNumbersSay() {
        QVERIFY((windowCurve(100, 60, 0.7f) == Curve{{70, 0}, {130, 0.7f}}));
        const Curve step = thresholdCurve(300, 1);
        QCOMPARE(valueAt(step, 299.9f), 0.0f);
        QCOMPARE(valueAt(step, 300), 1.0f);
        const Curve bell = bellCurve(40, 80, 0.6f);
        QCOMPARE(valueAt(bell, 40), 0.6f);
        QVERIFY(std::fabs(valueAt(bell, 0) - 0.3f) < 1e-6f && std::fabs(valueAt(bell, 80) - 0.3f) < 1e-6f);
        QCOMPARE(valueAt(bell, -40), 0.0f);
        QCOMPARE(valueAt(bell, 120), 0.0f);
        for (const Curve& shape : {windowCurve(32000, 9000, 1), bellCurve(-32700, 5000, 1), thresholdCurve(1e9f, 1)})
            QVERIFY(isOrdered(shape));
    }
};

QTEST_GUILESS_MAIN(CurveTest)
#include "curve_test.moc"
