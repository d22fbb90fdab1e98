/// The view of a slice: what pointer, wheel and keys request, in places of the patient.

#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

#include "render/slice/halved_plane.h"
#include "ui/slices/slice_view.h"

namespace pdr::ui {
namespace {

/// A coronal view of 300 x 200 that shows a plane of half a millimetre per pixel, and what it emits.
struct Shown {
    SliceView view{AnatomicalPlane::coronal};
    SlicePlane plane = SlicePlane::around({10, 20, 30}, {1, 0, 0}, {0, 0, -1}, 0.5, {300, 200});
    std::vector<dvec3> pointed;

    Shown() {
        view.resize(300, 200);
        view.show();
        QImage grey(300, 200, QImage::Format_RGBX8888);
        grey.fill(Qt::gray);
        view.setSlice({grey, plane, {"Coronal 1 of 2"}});
        QObject::connect(&view, &SliceView::pointed, [this](dvec3 mm) { pointed.push_back(mm); });
    }

    void wheel(double clicks, Qt::KeyboardModifiers modifiers = {}, QPointF at = {150, 100}) {
        QWheelEvent event(at, view.mapToGlobal(at), {}, {0, int(120 * clicks)}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&view, &event);
    }
};

/// Returns the slice of a ramp, as it is or coarse: a grey level that grows by 2 with x and y.
ShownSlice rampOn(const SlicePlane& plane, const SlicePlane& sampled) {
    QImage image(sampled.size.x, sampled.size.y, QImage::Format_RGB32);
    for (int y = 0; y < sampled.size.y; ++y)
        for (int x = 0; x < sampled.size.x; ++x) {
            const dvec2 pixel = plane.pixelAt(sampled.mmAt({x, y}));
            const int level = int(std::lround(10 + 2 * pixel.x + 2 * pixel.y));
            image.setPixel(x, y, qRgb(level, level, level));
        }
    return {image, plane, {}};
}

/// Returns the view of a slice, without a view.
QImage painted(const ShownSlice& slice) {
    QImage view(slice.plane.size.x, slice.plane.size.y, QImage::Format_RGB32);
    QPainter painter(&view);
    paintSlice(painter, slice, view.size());
    return view;
}

bool near(dvec3 a, dvec3 b) {
    return glm::length(a - b) < 1e-9;
}

}  // namespace

class SliceViewTest : public QObject {
    Q_OBJECT

  private slots:
    /// The pixel under the pointer is the one that was computed there: its centre is its place.
    void aClickPointsAtThePlaceUnderIt() {
        Shown shown;
        QTest::mouseClick(&shown.view, Qt::LeftButton, {}, {100, 50});
        QCOMPARE(shown.pointed.size(), std::size_t(2));  // pressed and let go
        QVERIFY(near(shown.pointed[1], shown.plane.mmAt({99.5, 49.5})));
        QCOMPARE(shown.pointed[1].y, 20.0);
    }

    void theWheelScrollsAndZooms() {
        Shown shown;
        QSignalSpy stepped(&shown.view, &SliceView::stepped), zoomed(&shown.view, &SliceView::zoomed);
        shown.wheel(1);
        shown.wheel(-1, Qt::ShiftModifier);
        QCOMPARE(stepped.size(), 2);
        QCOMPARE(stepped[0][0].toInt(), 1);
        QCOMPARE(stepped[1][0].toInt(), -5);
        shown.wheel(1, Qt::ControlModifier, {75, 50});
        QCOMPARE(stepped.size(), 2);
        QCOMPARE(zoomed.size(), 1);
        QVERIFY(zoomed[0][0].toDouble() > 1);
        QVERIFY(near(zoomed[0][1].value<dvec3>(), shown.plane.mmAt({74.5, 49.5})));
    }

    void smallTurnsOfATrackpadAddUp() {
        Shown shown;
        QSignalSpy stepped(&shown.view, &SliceView::stepped);
        for (int i = 0; i < 8; ++i)
            shown.wheel(0.25);
        QCOMPARE(stepped.size(), 2);
    }

    void keysScrollAndChooseWindows() {
        Shown shown;
        QSignalSpy stepped(&shown.view, &SliceView::stepped), window(&shown.view, &SliceView::windowChosen);
        QTest::keyClick(&shown.view, Qt::Key_Up);
        QTest::keyClick(&shown.view, Qt::Key_PageDown);
        QCOMPARE(stepped[0][0].toInt(), 1);
        QCOMPARE(stepped[1][0].toInt(), -10);
        QTest::keyClick(&shown.view, Qt::Key_4);
        QCOMPARE(window.size(), 1);
        QCOMPARE(window[0][0].value<char>(), '4');
    }

    /// Measuring needs no mouse: the crosshair is the pointer of the keyboard.
    void shiftedArrowsMoveTheCrosshairAndEnterClicksThere() {
        Shown shown;
        QSignalSpy nudged(&shown.view, &SliceView::nudged), stepped(&shown.view, &SliceView::stepped);
        const std::pair<Qt::Key, QPoint> arrows[] = {
            {Qt::Key_Left, {-1, 0}}, {Qt::Key_Right, {1, 0}}, {Qt::Key_Up, {0, -1}}, {Qt::Key_Down, {0, 1}}};
        for (const auto& [key, direction] : arrows) {
            QTest::keyClick(&shown.view, key, Qt::ShiftModifier);
            QCOMPARE(nudged.takeFirst()[0].toPoint(), direction);
        }
        QCOMPARE(stepped.size(), 0);
        const dvec3 crosshair = shown.plane.mmAt({220.25, 31.75});
        shown.view.setCrosshair(crosshair);
        QTest::keyClick(&shown.view, Qt::Key_Return);
        QCOMPARE(shown.pointed.size(), std::size_t(2));  // pressed and let go
        QVERIFY(near(shown.pointed[1], crosshair));
    }

    /// Digits turn the image elsewhere in the window, as shortcuts.
    void digitsBelongToTheSliceWithTheFocus() {
        Shown shown;
        QKeyEvent digit(QEvent::ShortcutOverride, Qt::Key_2, Qt::NoModifier, "2");
        digit.ignore();
        QCoreApplication::sendEvent(&shown.view, &digit);
        QVERIFY(digit.isAccepted());
        QKeyEvent other(QEvent::ShortcutOverride, Qt::Key_T, Qt::NoModifier, "t");
        other.ignore();
        QCoreApplication::sendEvent(&shown.view, &other);
        QVERIFY(!other.isAccepted());
    }

    void dragsMoveTheSliceWithThePointerAndChangeTheWindow() {
        Shown shown;
        dvec2 panned(0), window(0);
        connect(&shown.view, &SliceView::panned, [&](dvec2 mm) { panned += mm; });
        connect(&shown.view, &SliceView::windowDragged,
                [&](double wider, double brighter) { window += dvec2(wider, brighter); });
        const auto drag = [&](Qt::MouseButton button) {
            QTest::mousePress(&shown.view, button, {}, {100, 100});
            for (const QPointF to : {QPointF(120, 90), QPointF(140, 60)}) {
                QMouseEvent move(QEvent::MouseMove, to, shown.view.mapToGlobal(to), Qt::NoButton, button, {});
                QCoreApplication::sendEvent(&shown.view, &move);
            }
            QTest::mouseRelease(&shown.view, button, {}, {140, 60});
        };
        drag(Qt::MiddleButton);
        QVERIFY(glm::length(panned - dvec2(20, -20)) < 1e-9);  // 40 pixels of 0.5 mm
        QVERIFY(shown.pointed.empty());
        drag(Qt::RightButton);
        QVERIFY(glm::length(window - dvec2(40, 40) / 200.0) < 1e-9);
    }

    void aDoubleClickAsksForTheViewAlone() {
        Shown shown;
        QSignalSpy alone(&shown.view, &SliceView::aloneRequested);
        QTest::mouseDClick(&shown.view, Qt::LeftButton);
        QCOMPARE(alone.size(), 1);
    }

    /// The other slices are where the crosshair's lines are; the place itself stays free.
    void theCrosshairLiesOnItsPlace() {
        Shown shown;
        const QImage before = shown.view.grab().toImage();
        shown.view.setCrosshair(shown.plane.mmAt({59.5, 79.5}));
        const QImage after = shown.view.grab().toImage();
        const double ratio = after.devicePixelRatio();
        const auto at = [&](const QImage& image, int x, int y) { return image.pixel(int(x * ratio), int(y * ratio)); };
        QVERIFY(at(after, 200, 80) != at(before, 200, 80) || at(after, 200, 79) != at(before, 200, 79));
        QCOMPARE(at(after, 60, 80), qRgb(160, 160, 164));
        QCOMPARE(at(after, 200, 20), qRgb(160, 160, 164));
    }

    /// In a scan with a tilted gantry the axial slice cuts a sagittal one at an angle, and its line runs there.
    void aLineRunsWhereTheOtherSliceCuts() {
        const SlicePlane plane = SlicePlane::around({10, 20, 30}, {0, 1, 0}, {0, 0, -1}, 0.5, {300, 200});
        QImage image(300, 200, QImage::Format_RGB32);
        image.fill(Qt::black);
        ShownSlice slice{image, plane, {}};
        slice.lineAcross = {1, 0.5};
        QPainter painter(&image);
        paintCrosshair(painter, slice, AnatomicalPlane::sagittal, plane.mmAt({149.5, 99.5}), image.size());
        painter.end();
        const auto isLit = [&](int x, int y) {
            return image.pixel(x, y - 1) != qRgb(0, 0, 0) || image.pixel(x, y) != qRgb(0, 0, 0);
        };
        QVERIFY(isLit(250, 150) && isLit(50, 50) && isLit(290, 170));
        QVERIFY(!isLit(250, 100) && !isLit(50, 100) && !isLit(155, 103));
        QVERIFY(image.pixel(150, 30) != qRgb(0, 0, 0) || image.pixel(149, 30) != qRgb(0, 0, 0) ||
                image.pixel(150, 33) != qRgb(0, 0, 0));
    }

    /// A coarse pixel lies in the middle of the four that it stands for, and is painted there: nothing moves when the
    /// slice is made in full. The sizes are odd, so that the last coarse pixels reach beyond the slice.
    void aCoarseSliceLiesWhereTheFullOneDoes() {
        const SlicePlane plane = SlicePlane::around({10, 20, 30}, {0, 1, 0}, {0, 0, -1}, 0.37, {61, 41});
        const SlicePlane coarse = halved(plane);
        QVERIFY(coarse.size == ivec2(31, 21));
        for (const dvec2& pixel : {dvec2(0, 0), dvec2(12, 7), dvec2(30, 20)})
            QVERIFY(glm::distance(coarse.mmAt(pixel), plane.mmAt(2.0 * pixel + 0.5)) < 1e-6);
        const ShownSlice full = rampOn(plane, plane), half = rampOn(plane, coarse);
        QVERIFY(half.isCoarse() && !full.isCoarse());
        const QImage fine = painted(full), stretched = painted(half);
        double sum = 0;
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 60; ++x) {
                const int off = qGreen(stretched.pixel(x, y)) - qGreen(fine.pixel(x, y));
                QVERIFY(std::abs(off) <= 2);
                sum += off;
            }
        QCOMPARE(sum, 0.0);  // half a pixel to the right: -1 on average
    }

    void withoutASliceNothingIsRequested() {
        Shown shown;
        shown.view.clear();
        QSignalSpy zoomed(&shown.view, &SliceView::zoomed);
        QTest::mouseClick(&shown.view, Qt::LeftButton, {}, {100, 50});
        shown.wheel(1, Qt::ControlModifier);
        QVERIFY(shown.pointed.empty() && zoomed.isEmpty());
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::SliceViewTest)
#include "slice_view_test.moc"
