/// Measurements in a view: placing, dragging, and how those off the slice are shown.

#include <QImage>
#include <QSignalSpy>
#include <QTest>

#include "ui/annotation/slice_camera.h"
#include "ui/measure/marks_layer.h"
#include "ui/view/view_places.h"

namespace pdr::ui {
namespace {

/// An axial slice of half a millimetre per pixel in a view of 400 x 300, and a layer over it.
struct Over {
    SlicePlane plane = SlicePlane::around({10, 20, 30}, {1, 0, 0}, {0, 1, 0}, 0.5, {400, 300});
    ImagePlace image{QSize(400, 300), QRectF(0, 0, 400, 300), cameraFacing(plane)};
    MarksLayer layer{true};
    std::vector<std::pair<dvec3, bool>> placed;
    struct Drag {
        std::uint64_t id;
        int index;
        dvec3 mm;
        bool moving;
    };
    std::vector<Drag> drags;

    Over() {
        QObject::connect(&layer, &MarksLayer::placed, [this](dvec3 mm, bool free) { placed.emplace_back(mm, free); });
        QObject::connect(&layer, &MarksLayer::dragged,
                         [this](std::uint64_t id, int index, dvec3 mm, bool, bool moving) {
                             drags.push_back({id, index, mm, moving});
                         });
    }

    ViewPointer at(QPointF point, Qt::KeyboardModifiers modifiers = {}) const {
        return {point, Qt::LeftButton, Qt::LeftButton, modifiers, false, image};
    }
    dvec3 under(QPointF point) const { return plane.mmAt(dvec2(point.x(), point.y()) - 0.5); }
    QImage painted() const { return paintedBy(layer); }
    QImage paintedBy(const MarksLayer& shown) const {
        QImage painting(400, 300, QImage::Format_RGB32);
        painting.fill(Qt::black);
        QPainter painter(&painting);
        shown.paint(painter, image);
        return painting;
    }
};

bool near(dvec3 a, dvec3 b) {
    return glm::length(a - b) < 1e-9;
}

/// Returns how many pixels of the row at `y` are not black, from x = 100 to 299.
int inked(const QImage& image, int y) {
    int count = 0;
    for (int x = 100; x < 300; ++x)
        count += image.pixel(x, y) != qRgb(0, 0, 0);
    return count;
}

}  // namespace

class MarksLayerTest : public QObject {
    Q_OBJECT

  private slots:
    void whileDrawingAPressSetsAPlace() {
        Over over;
        QVERIFY(!over.layer.takes(over.at({100, 50})));
        over.layer.setDrawing(true);
        QVERIFY(over.layer.takes(over.at({100, 50})));
        over.layer.press(over.at({100, 50}));
        over.layer.press(over.at({101, 50}, Qt::AltModifier));
        QCOMPARE(over.placed.size(), std::size_t(2));
        QVERIFY(near(over.placed[0].first, over.under({100, 50})) && !over.placed[0].second);
        QVERIFY(over.placed[1].second);
        QVERIFY(!over.layer.takes(over.at({100, 50}, Qt::ShiftModifier)));  // moves the slice
    }

    /// With enough corners a click on the first one, a double click, or Enter closes; Backspace goes back at any time.
    void aPolygonIsClosed() {
        Over over;
        QSignalSpy closed(&over.layer, &MarksLayer::closed), back(&over.layer, &MarksLayer::takenBack);
        const QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, {}), backspace(QEvent::KeyPress, Qt::Key_Backspace, {});
        QVERIFY(!over.layer.key(backspace));
        over.layer.setDrawing(true);
        over.layer.setDrawn(MarkShape::polygon, {over.under({100, 100}), over.under({200, 100})});
        ViewPointer twice = over.at({200, 100});
        twice.twice = true;
        over.layer.press(twice);
        QVERIFY(over.placed.empty() && closed.isEmpty() && !over.layer.key(enter));
        over.layer.setDrawn(MarkShape::polygon,
                            {over.under({100, 100}), over.under({200, 100}), over.under({200, 200})});
        over.layer.setClosing(true, false);
        QVERIFY(!over.layer.key(enter));
        over.layer.press(over.at({120, 120}));
        QVERIFY(over.placed.size() == 1 && closed.isEmpty());
        over.layer.press(over.at({103, 98}));
        over.layer.press(twice);
        QVERIFY(over.placed.size() == 1 && closed.size() == 2);
        over.layer.setClosing(true, true);
        QVERIFY(over.layer.key(enter) && closed.size() == 3);
        QVERIFY(over.layer.key(backspace) && back.size() == 1);
        over.layer.setDrawing(false);
        QVERIFY(!over.layer.key(enter));
    }

    void aPolygonHasASideFromItsLastCornerToItsFirst() {
        Over over;
        std::vector<dvec3> corners;
        for (int n = 0; n < 48; ++n)
            corners.push_back(over.under({200 + 90 * std::cos(n / 7.6), 150 + 90 * std::sin(n / 7.6)}));
        const auto sides = curvesOf({.shape = MarkShape::polygon, .placesMm = corners}, *over.image.camera, false);
        QCOMPARE(sides.size(), corners.size());
        QVERIFY(near(sides.back().front(), corners.back()) && near(sides.back().back(), corners.front()));
        QVERIFY(sides[0].size() * sides.size() < 200);  // each part is looked for in the image
    }

    void escapeEndsDrawing() {
        Over over;
        QSignalSpy cancelled(&over.layer, &MarksLayer::drawingCancelled);
        QVERIFY(!over.layer.cancel());
        over.layer.setDrawing(true);
        QVERIFY(over.layer.cancel());
        QCOMPARE(cancelled.size(), 1);
    }

    void anEndIsDraggedByItsHandle() {
        Over over;
        over.layer.setMarks({{7, MarkShape::path, {over.under({100, 100}), over.under({200, 150})}, "56 mm"}});
        QVERIFY(!over.layer.takes(over.at({150, 125})));  // the line itself is no handle
        QVERIFY(over.layer.takes(over.at({203, 148})));
        over.layer.press(over.at({203, 148}));
        over.layer.move(over.at({220, 160}));
        over.layer.release(over.at({230, 170}));
        QCOMPARE(over.drags.size(), std::size_t(2));
        QVERIFY(over.drags[0].id == 7 && over.drags[0].index == 1 && over.drags[0].moving);
        QVERIFY(near(over.drags[1].mm, over.under({230, 170})) && !over.drags[1].moving);
    }

    void aClickOnAHandleSelectsAndMovesNothing() {
        Over over;
        QSignalSpy selected(&over.layer, &MarksLayer::selected);
        over.layer.setMarks({{7, MarkShape::path, {over.under({100, 100}), over.under({200, 150})}, ""}});
        over.layer.press(over.at({203, 148}));
        over.layer.move(over.at({204, 149}));  // a hand trembles
        over.layer.release(over.at({204, 149}));
        QCOMPARE(selected.size(), 1);
        QVERIFY(over.drags.empty());
    }

    /// Whoever drags a place sees it, so what lies off the slice has no handle there.
    void whatLiesOffTheSliceCannotBeDragged() {
        Over over;
        const dvec3 off(0, 0, 3);
        over.layer.setMarks({{7, MarkShape::path, {over.under({100, 100}) + off, over.under({200, 150}) + off}, ""}});
        QVERIFY(!over.layer.takes(over.at({200, 150})));
    }

    /// The end follows the pointer without its text, and is dropped as a point of the image: which place that is, is
    /// not known here. What is hidden, or lies in a slice, has no handle.
    void inTheImageAnEndIsDropped() {
        Over over;
        MarksLayer image(false);
        QSignalSpy dropped(&image, &MarksLayer::dropped), dragged(&image, &MarksLayer::dragged);
        const std::vector<dvec3> ends{over.under({100, 100}), over.under({200, 150}) + dvec3(0, 0, 9)};
        image.setMarks({{7, MarkShape::path, ends, "56 mm"}});
        const auto painted = [&] { return over.paintedBy(image); };
        const QImage before = painted();
        image.press(over.at({200, 150}));
        image.move(over.at({240, 170}));
        const MarkHandle end{7, 1};
        const ShownMark moved = movedTo(image.marks()[0], end, over.image, {240, 170});
        QVERIFY(near(moved.placesMm[1], over.under({240, 170}) + dvec3(0, 0, 9)) && moved.text.isEmpty());
        QVERIFY(near(moved.placesMm[0], ends[0]));
        QVERIFY(painted() != before);
        image.release(over.at({240, 170}));
        QVERIFY(dragged.isEmpty());
        QCOMPARE(dropped.size(), 1);
        QCOMPARE(dropped[0][2].toPointF(), QPointF(240 / 400.0, 170 / 300.0));
        QVERIFY(painted() != before);  // until its place is known
        image.putBack();
        QVERIFY(painted() == before);
        image.setHidden({{7, {{false, true}, {}}}});
        QVERIFY(image.takes(over.at({100, 100})) && !image.takes(over.at({200, 150})));
        image.setMarks({{7, MarkShape::polygon, {ends[0], ends[1], over.under({100, 200})}, ""}});
        QVERIFY(!image.takes(over.at({100, 100})));
    }

    /// Esc ends a drag; the rest of its moves do nothing. The owner of the measurement, which may have moved already,
    /// is asked to restore it.
    void escapeEndsADrag() {
        Over over;
        for (const bool slice : {true, false}) {
            MarksLayer layer(slice);
            QSignalSpy cancelled(&layer, &MarksLayer::dragCancelled), dragged(&layer, &MarksLayer::dragged),
                dropped(&layer, &MarksLayer::dropped);
            layer.setMarks({{7, MarkShape::path, {over.under({100, 100}), over.under({200, 150})}, ""}});
            const QImage before = over.paintedBy(layer);
            layer.press(over.at({200, 150}));
            layer.move(over.at({240, 150}));
            QVERIFY(layer.cancel());
            layer.move(over.at({250, 150}));
            layer.release(over.at({250, 150}));
            QVERIFY(over.paintedBy(layer) == before);
            QVERIFY(cancelled.size() == 1 && dragged.size() == slice && dropped.isEmpty());
            QVERIFY(!layer.cancel());
        }
    }

    void whileDrawingTheImagesMarksCannotBeDragged() {
        Over over;
        MarksLayer image(false);
        image.setMarks({{7, MarkShape::path, {over.under({100, 100}), over.under({200, 150})}, ""}});
        image.setDrawing(true);
        QVERIFY(!image.takes(over.at({200, 150})));
        QVERIFY(!image.hover(over.at({200, 150})));  // and the pointer sets nothing
        QSignalSpy cancelled(&image, &MarksLayer::drawingCancelled);
        QVERIFY(image.cancel() && cancelled.size() == 1);  // Esc reaches the image's tools first
    }

    /// Two lines are not joined: nothing is drawn from the end of the first to the beginning of the second.
    void twoLinesAreNotJoined() {
        Over over;
        const std::vector<dvec3> places{over.under({20, 60}), over.under({380, 60}), over.under({20, 240}),
                                        over.under({380, 240})};
        const auto inkedHalfway = [&](MarkShape shape) {
            over.layer.setMarks({{7, shape, places, ""}});
            return inked(over.painted(), 150);
        };
        QVERIFY(inkedHalfway(MarkShape::path) > 0);
        QCOMPARE(inkedHalfway(MarkShape::lines), 0);
    }

    /// A slice cuts a ball in a circle, which is smaller off its middle; what it does not cut is not shown.
    void aBallIsWhereTheSliceCutsIt() {
        Over over;
        const auto halfWidth = [&](double offMm) {  // of the circle, along the row through its middle [px]
            const dvec3 centre = over.under({200, 150}) + dvec3(0, 0, offMm);
            over.layer.setMarks({{7, MarkShape::ball, {centre, centre + dvec3(0, 0, 25)}, ""}});
            const QImage painted = over.painted();
            for (int x = 100; x < 190; ++x)
                if (painted.pixel(x, 150) != qRgb(0, 0, 0))
                    return 200 - x;
            return 0;
        };
        QVERIFY(std::abs(halfWidth(0) - 50) <= 2);
        QVERIFY(std::abs(halfWidth(-15) - 40) <= 2);
        QCOMPARE(halfWidth(26), 0);
    }

    /// In the image a ball is as large as it is.
    void inTheImageABallHasItsOutline() {
        Over over;
        const ShownMark ball{.shape = MarkShape::ball, .placesMm = {{10, 20, 60}, {10, 45, 60}}};
        const std::vector<MarkCurve> curves = curvesOf(ball, *over.image.camera, false);
        QCOMPARE(curves.size(), std::size_t(1));
        for (const dvec3& place : curves[0])
            QVERIFY(std::abs(glm::distance(place, dvec3(10, 20, 60)) - 25) < 1e-9);
        QVERIFY(near(curves[0].front(), curves[0].back()));
    }

    /// The third place says how far aside an ellipse reaches, wherever it lies beside the axis.
    void anEllipseReachesAsFarAsItsPlaces() {
        Over over;
        const dvec3 middle = over.under({200, 150}), end = over.under({300, 150}), aside = over.under({240, 110});
        const auto curves =
            curvesOf({.shape = MarkShape::ellipse, .placesMm = {middle, end, aside}}, *over.image.camera, true);
        QCOMPARE(curves.size(), std::size_t(1));
        QVERIFY(near(curves[0].front(), end) && near(curves[0].back(), end));
        for (const dvec3& place : curves[0]) {
            const dvec2 away = (over.plane.pixelAt(place) - over.plane.pixelAt(middle)) / dvec2(100, 40);
            QVERIFY(std::abs(glm::length(away) - 1) < 1e-9);
        }
        // While its second axis is open, the first is drawn.
        QCOMPARE(curvesOf({.shape = MarkShape::ellipse, .placesMm = {middle, end}}, *over.image.camera, true).size(),
                 std::size_t(1));
    }

    void whatIsHiddenInTheImageIsDotted() {
        Over over;
        MarksLayer layer(false);
        layer.setMarks({{7, MarkShape::path, {over.under({100, 200}), over.under({299, 200})}, ""}});
        MarkHidden hidden{{true, true}, {std::vector<bool>(kCurveParts)}};
        std::fill_n(hidden.parts[0].begin(), kCurveParts / 2, true);  // the left half
        QSignalSpy changed(&layer, &MarksLayer::changed);
        layer.setHidden({{7, hidden}});
        QCOMPARE(changed.size(), 1);
        const QImage dotted = over.paintedBy(layer);
        const auto brightness = [&](int from) {  // of 80 pixels of the line
            int sum = 0;
            for (int x = from; x < from + 80; ++x)
                sum += qGray(dotted.pixel(x, 199)) + qGray(dotted.pixel(x, 200));
            return sum;
        };
        const double share = double(brightness(110)) / brightness(210);
        QVERIFY2(share > 0.1 && share < 0.6, qPrintable(QString::number(share)));
    }

    void aMeasurementOffTheSliceIsDashedAndGoesAtLast() {
        Over over;
        const auto inkAt = [&](double offMm) {
            over.layer.setMarks(
                {{7,
                  MarkShape::path,
                  {over.under({100, 200}) + dvec3(0, 0, offMm), over.under({299, 200}) + dvec3(0, 0, offMm)},
                  ""}});
            return inked(over.painted(), 199) + inked(over.painted(), 200);
        };
        const int solid = inkAt(0), dashed = inkAt(2), gone = inkAt(21);
        QVERIFY(solid >= 380);
        QVERIFY2(dashed > 0 && dashed <= solid, qPrintable(QString("%1 of %2").arg(dashed).arg(solid)));
        QVERIFY(over.painted().isNull() == false && gone == 0);
    }

    /// A text says how far a measurement lies off the slice.
    void theDistanceFromTheSliceIsWritten() {
        Over over;
        const auto picture = [&](double offMm) {
            over.layer.setMarks(
                {{7, MarkShape::path, {over.under({50, 200}) + dvec3(0, 0, offMm), over.under({60, 200})}, "5 mm"}});
            return over.painted();
        };
        QVERIFY(picture(0) == picture(0.1));  // within the slice
        QVERIFY(picture(0) != picture(2.0));
    }

    void placesInViewsAndBack() {
        Over over;
        for (const QPointF point : {QPointF(0, 0), QPointF(399, 10), QPointF(200.5, 150.25)}) {
            QVERIFY(near(placeUnder(over.image, point), over.under(point)));
            const auto seen = seenAt(over.image, over.under(point) + dvec3(0, 0, 5));  // along the view
            QVERIFY(seen && QLineF(*seen, point).length() < 1e-6);
        }
        QVERIFY(std::abs(depthMm(over.image, over.under({3, 4}) + 2.5 * over.plane.normal()) - 2.5) < 1e-9);
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::MarksLayerTest)
#include "marks_layer_test.moc"
