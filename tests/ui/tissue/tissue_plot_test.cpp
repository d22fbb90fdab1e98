/// The tissue plot: its scale, its histogram, its outline, and the edits of its points.

#include <QTest>
#include <algorithm>

#include "render/volume/volume.h"
#include "ui/tissue/curve_hand.h"
#include "ui/tissue/curve_painter.h"
#include "ui/tissue/curve_shape.h"
#include "ui/tissue/histogram_bars.h"
#include "ui/widgets/screen_colour.h"

namespace pdr::ui {

/// Returns a view of 500 x 100 pixels, in which a pixel is 2 HU.
static PlotView plain() {
    PlotView view;
    view.setArea({10, 20, 500, 100});
    view.show(-500, 500);
    return view;
}

/// Returns a histogram with `counts[i]` voxels of i HU.
static Histogram of(const std::vector<int>& counts) {
    Voxels voxels;
    for (std::size_t hu = 0; hu < counts.size(); ++hu)
        voxels.insert(voxels.end(), std::size_t(counts[hu]), std::int16_t(hu));
    return Histogram(Volume(VolumeGeometry::aligned({int(voxels.size()), 1, 1}, dvec3(1), dvec3(0)), voxels));
}

static const Curve kCurve{{-100, 0}, {0, 0.2f}, {0, 0.5f}, {200, 1}, {400, 0.3f}};

class TestTissuePlot : public QObject {
    Q_OBJECT

  private slots:
    void theScaleGoesBothWays();
    void zoomingKeepsThePlaceUnderTheMouse();
    void marksAreRoundAndFew();
    void airDoesNotFlattenTheHistogram();
    void barsHoldAllVoxelsThatAreSeen();
    void theOutlineHasFourPlacesAColumn();
    void aPressChoosesThePointUnderIt();
    void shiftChoosesSeveral();
    void aDragMovesWhatIsSelected();
    void aTremblingClickMovesNothing();
    void aPressOnTheLineAddsAPoint();
    void aRubberBandChooses();
    void ofPointsAtAStepBothCanBeHeld();
    void aThousandPointsAreEditedOneByOne();
    void aShapeBeginsWhereTheCurveIs();
    void coloursSurviveTheScreen();
};

void TestTissuePlot::theScaleGoesBothWays() {
    const PlotView view = plain();
    QCOMPARE(view.at(-500, 0), QPointF(10, 120));
    QCOMPARE(view.at(500, 1), QPointF(510, 20));
    QCOMPARE(view.hu(view.x(123)), 123.0);
    QCOMPARE(view.value(view.y(0.37)), 0.37);
}

void TestTissuePlot::zoomingKeepsThePlaceUnderTheMouse() {
    PlotView view = plain();
    const double hu = view.hu(110);
    for (const double factor : {2.0, 1e9, 1e-9, 1.25}) {
        view.zoom(110, factor);
        QVERIFY(std::abs(view.hu(110) - hu) < 1e-6);
        QVERIFY(view.highHu() - view.lowHu() >= PlotView::kNarrowest - 1e-6);
        QVERIFY(view.highHu() - view.lowHu() <= PlotView::kWidest + 1e-6);
    }
    view.pan(7);
    QVERIFY(std::abs(view.hu(117) - hu) < 1e-6);
}

void TestTissuePlot::marksAreRoundAndFew() {
    QCOMPARE(roundMarks(-1000, 3000, 5), (std::vector<double>{-1000, 0, 1000, 2000, 3000}));
    QCOMPARE(roundMarks(0, 1.2, 3), (std::vector<double>{0, 0.5, 1}));
    for (int most = 1; most < 12; ++most)
        for (const double high : {0.003, 1.0, 70.0, 65535.0})
            QVERIFY(int(roundMarks(0, high, most).size()) <= most + 1);
    QVERIFY(roundMarks(1, 1, 4).empty());
}

/// A tenth of the columns hold a thousand times as many voxels.
void TestTissuePlot::airDoesNotFlattenTheHistogram() {
    std::vector<int> counts(100, 50);
    std::fill_n(counts.begin(), 8, 50'000);
    PlotView view = plain();
    view.setArea({0, 0, 100, 100});
    view.show(-0.5, 99.5);
    for (const BarScale scale : {BarScale::linear, BarScale::logarithmic}) {
        const std::vector<double> bars = histogramBars(of(counts), view, scale);
        QCOMPARE(bars.size(), std::size_t(100));
        QVERIFY(bars[50] > 0.2);
        QVERIFY(bars[3] > bars[50]);
        QVERIFY(std::ranges::max(bars) <= 1);
    }
    QVERIFY(histogramBars(Histogram(), view, BarScale::linear).empty());
}

void TestTissuePlot::barsHoldAllVoxelsThatAreSeen() {
    PlotView view = plain();
    view.setArea({0, 0, 10, 100});
    view.show(-0.5, 99.5);
    const std::vector<double> bars = histogramBars(of({std::vector<int>(100, 30)}), view, BarScale::linear);
    for (const double bar : bars)
        QVERIFY(std::abs(bar - 0.8) < 1e-9);
}

/// The limit holds for any number of points; the outline is as high as the highest of them.
void TestTissuePlot::theOutlineHasFourPlacesAColumn() {
    Curve curve;
    for (int i = 0; i < 4096; ++i)
        curve.push_back({float(-500 + i / 4.096), i == 2000 ? 1.0f : 0.1f});
    const QPolygonF outline = outlineOf(curve, plain());
    QVERIFY(outline.size() <= 4 * 501 + 2);
    QCOMPARE(std::ranges::min(outline, {}, &QPointF::y).y(), 20.0);
    QCOMPARE(outline.front().x(), 10.0);
    QCOMPARE(outline.back().x(), 510.0);
}

void TestTissuePlot::aPressChoosesThePointUnderIt() {
    CurveHand hand;
    hand.setCurve(kCurve, 1);
    const PlotView view = plain();
    QVERIFY(!hand.press(view, view.at(200, 1) + QPointF(3, 4), {}));
    QCOMPARE(hand.selection(), CurveSelection{3});
    QVERIFY(!hand.release());
    QVERIFY(hand.curve() == kCurve);
}

void TestTissuePlot::shiftChoosesSeveral() {
    CurveHand hand;
    hand.setCurve(kCurve, 1);
    const PlotView view = plain();
    for (const double hu : {400.0, -100.0})
        hand.press(view, view.at(hu, double(valueAt(kCurve, float(hu)))), Qt::ShiftModifier), hand.release();
    QCOMPARE(hand.selection(), (CurveSelection{0, 4}));
    hand.press(view, view.at(400, 0.3), Qt::ShiftModifier);
    QCOMPARE(hand.selection(), CurveSelection{0});
}

void TestTissuePlot::aDragMovesWhatIsSelected() {
    CurveHand hand;
    hand.setCurve(kCurve, 1);
    const PlotView view = plain();
    hand.press(view, view.at(400, 0.3), {});
    QVERIFY(hand.drag(view, view.at(440, 0.6)));
    QCOMPARE(hand.curve()[4].hu, 440.0f);
    QVERIFY(std::abs(hand.curve()[4].value - 0.6f) < 1e-6f);
    QVERIFY(hand.drag(view, view.at(400, 0.3)));
    QVERIFY(hand.curve() == kCurve);  // there and back, to the bit
    QVERIFY(hand.release());
    QVERIFY(!hand.drag(view, view.at(300, 0.3)));
}

void TestTissuePlot::aTremblingClickMovesNothing() {
    CurveHand hand;
    hand.setCurve(kCurve, 1);
    const PlotView view = plain();
    hand.press(view, view.at(400, 0.3), {});
    QVERIFY(!hand.drag(view, view.at(400, 0.3) + QPointF(1, -2)));
    QVERIFY(!hand.release());
    QVERIFY(hand.curve() == kCurve);
}

void TestTissuePlot::aPressOnTheLineAddsAPoint() {
    CurveHand hand;
    hand.setCurve(kCurve, 1);
    const PlotView view = plain();
    QVERIFY(hand.press(view, view.at(100, 0.75), {}));
    QCOMPARE(hand.curve().size(), std::size_t(6));
    QCOMPARE(hand.selection(), CurveSelection{3});
    QCOMPARE(hand.curve()[3].hu, 100.0f);
    QCOMPARE(hand.curve()[3].value, 0.75f);
    QVERIFY(hand.drag(view, view.at(140, 0.1)));  // and follows at once
    QCOMPARE(hand.curve()[3].hu, 140.0f);
    QVERIFY(hand.release());
    QVERIFY(!hand.press(view, view.at(-300, 0.8), {}));  // beside the line nothing is added, ...
    hand.release();
    QVERIFY(hand.press(view, view.at(-300, 0.8), Qt::ControlModifier));  // ... unless it is asked for
    QCOMPARE(hand.curve()[0].hu, -300.0f);
}

void TestTissuePlot::aRubberBandChooses() {
    CurveHand hand;
    hand.setCurve(kCurve, 1);
    const PlotView view = plain();
    hand.press(view, view.at(-400, 0.9), {});
    QVERIFY(!hand.band());
    QVERIFY(!hand.drag(view, view.at(50, 0.1)));
    QVERIFY(hand.band());
    QCOMPARE(hand.selection(), (CurveSelection{1, 2}));
    QVERIFY(!hand.release());
    QVERIFY(!hand.band() && hand.curve() == kCurve);
    hand.press(view, view.at(-400, 0.9), {});
    hand.release();
    QVERIFY(hand.selection().empty());
}

/// The right point moves by itself, the left one once the other is out of the way; neither passes the other.
void TestTissuePlot::ofPointsAtAStepBothCanBeHeld() {
    const Curve step{{0, 0.5f}, {0, 0.5f}};
    CurveHand hand;
    hand.setCurve(step, 1);
    const PlotView view = plain();
    hand.press(view, view.at(0, 0.5), {});
    QVERIFY(hand.drag(view, view.at(80, 0.5)));
    hand.release();
    QVERIFY((hand.curve() == Curve{{0, 0.5f}, {80, 0.5f}}));
    hand.press(view, view.at(0, 0.5), {});
    hand.drag(view, view.at(300, 0.5));
    QVERIFY((hand.curve() == Curve{{80, 0.5f}, {80, 0.5f}}));
}

/// Each point is found, and moving it changes no other.
void TestTissuePlot::aThousandPointsAreEditedOneByOne() {
    Curve curve;
    for (int i = 0; i < 1000; ++i)
        curve.push_back({float(20 * i), i % 2 ? 0.9f : 0.1f});
    CurveHand hand;
    hand.setCurve(curve, 1);
    for (std::size_t i = 0; i < curve.size(); i += 37) {
        PlotView view = plain();
        view.show(double(curve[i].hu) - 200, double(curve[i].hu) + 200);
        hand.press(view, view.at(double(curve[i].hu), double(curve[i].value)), {});
        QCOMPARE(hand.selection(), CurveSelection{i});
        hand.drag(view, view.at(double(curve[i].hu) + 6, 0.5));
        hand.release();
        curve[i] = {curve[i].hu + 6, hand.curve()[i].value};
        QVERIFY(hand.curve() == curve);
    }
}

void TestTissuePlot::aShapeBeginsWhereTheCurveIs() {
    const Histogram histogram = of(std::vector<int>(1000, 1));
    const Curve ramp{{100, 0}, {300, 0.8f}};
    const auto like = [&](CurveShape::Kind kind) { return curveOf(shapeLike(ramp, kind, histogram), 0.8f, histogram); };
    QVERIFY(std::abs(valueAt(like(CurveShape::Kind::window), 200) - 0.4f) < 0.01f);
    QCOMPARE(like(CurveShape::Kind::threshold)[1].hu, 200.0f);
    QCOMPARE(firstAt(like(CurveShape::Kind::bell), 0.8f), 290.0f);
    QVERIFY(std::abs(valueAt(like(CurveShape::Kind::percentiles), 200) - 0.4f) < 0.01f);
    const Curve backwards = curveOf({CurveShape::Kind::percentiles, 90, 10}, 1, histogram);
    QVERIFY(std::ranges::is_sorted(backwards, {}, &CurvePoint::hu));
}

void TestTissuePlot::coloursSurviveTheScreen() {
    for (const vec3 colour : {vec3(0.86f, 0.16f, 0.08f), vec3(0), vec3(1), vec3(0.5f, 0.02f, 0.9f)})
        QVERIFY(glm::length(linearColour(screenColour(colour)) - colour) < 0.01f);
    QCOMPARE(screenColour(vec3(0.2140f)).red(), 127);  // IEC 61966-2-1
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestTissuePlot)
#include "tissue_plot_test.moc"
