/// Ellipses and polygons in the window: drawn on one slice, in which they lie.

#include <cmath>
#include <numbers>

#include "app/plan/measured.h"
#include "app/presenters/slice_framing.h"
#include "tests/support/desktop/plate_trial.h"
#include "tests/support/desktop/the.h"

namespace pdr::app {

class FlatMarksInWindowTest : public QObject, PlateTrial {
    Q_OBJECT

  private slots:
    void initTestCase() { begin(); }
    void cleanupTestCase() { trial_.reset(); }

    /// It stays in the plane of its first click, though the slice is scrolled by a part of its thickness, and its axes
    /// stay perpendicular.
    void anEllipseSaysTheMeanInItsSlice() {
        const std::size_t before = measurements().size();
        key(Qt::Key_O, Qt::ShiftModifier);
        click(centre_);
        click(centre_ + dvec3(6, 0, 0));
        showAxialAt(centre_ + dvec3(0, 0, 0.4));
        click(centre_ + dvec3(3, 9, 0));
        showAxialAt(centre_);
        QCOMPARE(measurements().size(), before + 1);
        const Measurement& drawn = measurements().back();
        QCOMPARE(drawn.kind, MeasureKind::ellipse);
        for (const measure::Place& place : drawn.places)
            QVERIFY(std::abs(place.mm.z - centre_.z) < 1e-9 && !isAtEdge(place));
        const dvec3 u = drawn.places[1].mm - drawn.places[0].mm, v = drawn.places[2].mm - drawn.places[0].mm;
        QVERIFY(std::abs(glm::dot(u, v)) < 1e-9 && std::abs(glm::length(v) - 9) < 0.5);
        const auto value = measured(drawn, *document().seen());
        QVERIFY(value && std::abs(value->value - 1000) < 2);
        QVERIFY(std::abs(double(value->region->count) - 54 * std::numbers::pi) < 20);
        QVERIFY(shown(int(before), 1).contains("HU"));
        drag(drawn.places[0].mm, centre_ + dvec3(0, 5, 0));
        QVERIFY(std::abs(glm::distance(measurements().back().places[0].mm, measurements().back().places[2].mm) -
                         glm::length(v)) < 1e-9);
        QCOMPARE(document().undoText(), Text("Undo changing a measurement"));
        document().undo();
        while (measurements().size() > before)
            document().undo();
    }

    /// In another slice it is not seen: a click there sets no place, and the window says where it is, and goes there.
    void aFigureIsDrawnInOneSlice() {
        const std::size_t before = measurements().size();
        showAxialAt(centre_);
        key(Qt::Key_O, Qt::ShiftModifier);
        QCOMPARE(coronal().cursor().shape(), Qt::CrossCursor);
        click(centre_);
        QCOMPARE(coronal().cursor().shape(), Qt::ForbiddenCursor);
        QCOMPARE(axial().cursor().shape(), Qt::CrossCursor);
        QTest::mouseClick(&coronal(), Qt::LeftButton, {}, coronal().rect().center());
        const int number = nearestSlice(SliceStack(document().seen()->geometry(), AnatomicalPlane::axial), centre_) + 1;
        const QString where = QString("The figure lies in axial slice %1. Click there").arg(number);
        QVERIFY2(message().text().startsWith(where), qPrintable(message().text()));
        message().clear();
        showAxialAt(centre_ + dvec3(0, 0, 4));
        click(centre_ + dvec3(6, 0, 0));
        QVERIFY2(message().text().startsWith(where), qPrintable(message().text()));
        test::the<QPushButton>(message()).click();  // Show that slice
        showAxialAt(centre_);
        click(centre_ + dvec3(6, 0, 0));
        click(centre_ + dvec3(3, 9, 0));
        QCOMPARE(measurements().size(), before + 1);
        QVERIFY(std::abs(glm::distance(measurements().back().places[0].mm, measurements().back().places[1].mm) - 6) <
                0.5);
        document().undo();
    }

    /// The pointer over the image is the ordinary one, and a click there says why.
    void aFigureIsNotDrawnInTheImage() {
        showAxialAt(centre_);
        key(Qt::Key_M);
        QCOMPARE(viewport().cursor().shape(), Qt::CrossCursor);
        key(Qt::Key_M, Qt::ShiftModifier);
        QCOMPARE(viewport().cursor().shape(), Qt::ArrowCursor);
        QCOMPARE(axial().cursor().shape(), Qt::CrossCursor);
        const QPoint at = viewport().rect().center() - QPoint(0, 20);
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, at);
        QVERIFY2(trial_->said().contains("This figure is drawn on a slice. Click there"), qPrintable(trial_->said()));
        click(centre_);
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, at);
        QVERIFY2(message().text().startsWith("The figure lies in axial slice"), qPrintable(message().text()));
        QTest::qWait(200);  // a click that moves the crosshair does so later
        QVERIFY(document().plan().navigation.crosshairMm == centre_);
        key(Qt::Key_Escape);
        QVERIFY(message().text().isEmpty());
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, at);
        QTRY_VERIFY_WITH_TIMEOUT(document().plan().navigation.crosshairMm != centre_, test::kPatience);
    }

    /// Shift and the arrows move the crosshair, Enter sets a corner there, and once more closes the polygon.
    void keysAloneDrawAPolygon() {
        const std::size_t before = measurements().size();
        showAxialAt(centre_);
        viewport().setFocus();
        key(Qt::Key_M, Qt::ShiftModifier);
        QCOMPARE(window().focusWidget(), &axial());
        const auto press = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = {}, int times = 1) {
            for (int n = 0; n < times; ++n)
                QTest::keyClick(window().focusWidget(), key, modifiers);
        };
        press(Qt::Key_Return, Qt::AltModifier);
        press(Qt::Key_Right, Qt::ShiftModifier, 8);
        press(Qt::Key_Return, Qt::AltModifier);
        press(Qt::Key_Down, Qt::ShiftModifier, 9);
        press(Qt::Key_Return, Qt::AltModifier);
        press(Qt::Key_Backspace);
        press(Qt::Key_Up, Qt::ShiftModifier, 3);
        press(Qt::Key_Return, Qt::AltModifier);
        press(Qt::Key_Left, Qt::ShiftModifier, 8);
        press(Qt::Key_Return, Qt::AltModifier);
        QCOMPARE(measurements().size(), before);
        press(Qt::Key_Return);
        QCOMPARE(measurements().size(), before + 1);
        const auto value = measured(measurements().back(), *document().seen());
        QCOMPARE(measurements().back().places.size(), std::size_t(4));
        QVERIFY2(value && std::abs(value->value - 48) < 1e-6, qPrintable(QString::number(value->value)));
        document().undo();
    }

    /// Its corners go to edges; a click on the first one closes it, and a double click does not fill the window.
    void aPolygonMeasuresTheFaceOfThePlate() {
        const std::size_t before = measurements().size();
        const auto begin = [&] { key(Qt::Key_M, Qt::ShiftModifier); };
        begin();
        for (const dvec3& corner : {dvec3(-9, -8, 0), dvec3(10.8, -8, 0), dvec3(30, 20, 0)})
            click(centre_ + corner);
        QTest::keyClick(&axial(), Qt::Key_Backspace);
        click(centre_ + dvec3(10.8, 7, 0));
        click(centre_ + dvec3(-9, 7, 0));
        QCOMPARE(measurements().size(), before);
        click(centre_ + dvec3(-10, -8, 0));  // the edge to which it went
        QCOMPARE(measurements().size(), before + 1);
        const Measurement drawn = measurements().back();
        QCOMPARE(drawn.kind, MeasureKind::polygon);
        QCOMPARE(drawn.places.size(), std::size_t(4));
        QVERIFY(isAtEdge(drawn.places[0]) && isAtEdge(drawn.places[2]));
        const auto value = measured(drawn, *document().seen());
        QVERIFY(value && value->plusMinus && value->region);
        QVERIFY2(std::abs(value->value - 300) < 12 + *value->plusMinus, value->text.c_str());
        QVERIFY(shown(int(before), 1).contains(QString::fromUtf8("mm²")));
        QCOMPARE(document().undoText(), Text("Undo measuring"));
        document().undo();
        begin();
        for (const dvec3& corner : {dvec3(-5, -5, 0), dvec3(5, -5, 0), dvec3(5, 5, 0)})
            click(centre_ + corner, Qt::AltModifier);
        const auto layout = window().views().layout();
        QTest::mouseDClick(&axial(), Qt::LeftButton, {}, pointOn(axial(), centre_ + dvec3(5, 5, 0)));
        QTest::mouseRelease(&axial(), Qt::LeftButton, {}, pointOn(axial(), centre_ + dvec3(5, 5, 0)));
        QVERIFY(window().views().layout() == layout && axial().width() < 1000);
        QCOMPARE(measurements().size(), before + 1);
        document().undo();
        begin();
        for (const dvec3& corner : {dvec3(-5, -5, 0), dvec3(5, -5, 0), dvec3(5, 5, 0)})
            click(centre_ + corner, Qt::AltModifier);
        QTest::keyClick(&axial(), Qt::Key_Return);
        QCOMPARE(measurements().size(), before + 1);
        QVERIFY(std::abs(measured(measurements().back(), *document().seen())->value - 50) < 8);
        document().undo();
        QCOMPARE(measurements().size(), before);
    }

    /// A click too many says so.
    void aPolygonHasNoMoreCornersThanAFileHolds() {
        const std::size_t before = measurements().size();
        key(Qt::Key_M, Qt::ShiftModifier);
        const int most = int(kMostCorners);
        for (int n = 0; n < most + 2; ++n) {
            const double turn = 6 * double(n) / most;
            click(centre_ + dvec3(25 * std::cos(turn), 25 * std::sin(turn), 0), Qt::AltModifier);
        }
        QTest::keyClick(&axial(), Qt::Key_Return);
        QCOMPARE(measurements().size(), before + 1);
        QCOMPARE(measurements().back().places.size(), kMostCorners);
        document().undo();
    }

  private:
    ui::SliceView& coronal() { return view(AnatomicalPlane::coronal); }
    ui::MessageBar& message() { return window().message(); }
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::FlatMarksInWindowTest)
#include "flat_marks_in_window_test.moc"
