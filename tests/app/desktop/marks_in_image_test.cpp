/// Measuring on the image: places that are picked, dragged, and hidden.

#include <QLineF>
#include <QMenu>
#include <QSignalSpy>
#include <algorithm>
#include <cmath>

#include "app/plan/measured.h"
#include "tests/support/desktop/plate_trial.h"
#include "ui/view/view_places.h"

namespace pdr::app {

class MarksInImageTest : public QObject, PlateTrial {
    Q_OBJECT

  private slots:
    void initTestCase() { begin(); }
    void cleanupTestCase() { trial_.reset(); }

    /// Once from either side: each face of the plate is where the ray under the pointer meets its edge.
    void twoClicksOnTheImageMeasureThePlate() {
        const std::size_t before = measurements().size();
        const auto& looks = document().looks().fitted();
        document().chooseLook(int(std::ranges::find(looks, "Bone", &NamedLook::name) - looks.begin()));
        key(Qt::Key_M);
        for (const StandardView side : {StandardView::left, StandardView::right}) {
            document().setView(side);
            waitForImage();
            const dvec3 crosshair = document().plan().navigation.crosshairMm;
            QTest::mouseClick(&viewport(), Qt::LeftButton, {}, viewport().rect().center());
            QTRY_VERIFY_WITH_TIMEOUT(document().plan().navigation.crosshairMm != crosshair, test::kPatience);
        }
        QTRY_COMPARE_WITH_TIMEOUT(measurements().size(), before + 1, test::kPatience);
        const Measurement& picked = measurements().back();
        QVERIFY(picked.places[0].found == measure::Found::pickedEdge);
        QVERIFY(picked.places[1].found == measure::Found::pickedEdge);
        const auto value = measured(picked, *document().seen());
        QVERIFY2(value && std::abs(value->value - 20) < 0.5, qPrintable(QString::number(value->value)));
        QVERIFY(std::abs(value->value - 20) <= value->plusMinus.value());
    }

    /// Seen from the right, the left face of the plate is behind the plate.
    void whatLiesBehindIsKnownToBeHidden() {
        const std::uint64_t id = measurements().back().id;
        const auto& hidden = presenter().inImage().hidden();
        const auto places = [&] { return hidden.contains(id) ? hidden.at(id).places : std::vector<bool>(); };
        QTRY_VERIFY_WITH_TIMEOUT((places() == std::vector<bool>{true, false}), test::kPatience);
        QVERIFY(hidden.at(id).parts[0].front() && !hidden.at(id).parts[0].back());
        document().setView(StandardView::left);
        QTRY_VERIFY_WITH_TIMEOUT((places() == std::vector<bool>{false, true}), test::kPatience);
    }

    /// The handle of what is seen, along the face of the plate: its new place is at the edge there, too.
    void anEndIsDraggedAlongItsSurface() {
        const Measurement before = measurements().back();
        showFromTheRight();
        const Camera camera = document().setup().camera;
        const QPoint from = pointOf(before.places[1].mm), to = from + QPoint(0, 40);
        test::dragOn(viewport(), from, Qt::NoButton);  // hovers
        QTRY_COMPARE(viewport().cursor().shape(), Qt::SizeAllCursor);
        dragInImage(from, to);
        QTRY_VERIFY_WITH_TIMEOUT(measurements().back() != before, test::kPatience);
        const Measurement& moved = measurements().back();
        QVERIFY(moved.places[0] == before.places[0] && moved.places[1].found == measure::Found::pickedEdge);
        QVERIFY(std::abs(moved.places[1].mm.x - before.places[1].mm.x) < 0.2);
        QVERIFY(QLineF(pointOf(moved.places[1].mm), to).length() < 2);
        QVERIFY(document().setup().camera == camera);
        QCOMPARE(document().undoText(), Text("Undo changing a measurement"));
        document().undo();
        QVERIFY(measurements().back() == before);
    }

    /// Where the image shows no place, the end goes back to where it was, and the window says why.
    void anEndStaysWhereNothingIsSeen() {
        const Measurement before = measurements().back();
        const QPoint from = pointOf(before.places[1].mm);
        dragInImage(from, {12, viewport().height() / 2});
        QTRY_VERIFY_WITH_TIMEOUT(trial_->said().contains("No tissue at this point"), test::kPatience);
        QVERIFY(measurements().back() == before);
        test::dragOn(viewport(), from, Qt::NoButton);  // hovers
        QTRY_COMPARE(viewport().cursor().shape(), Qt::SizeAllCursor);
    }

    /// Where the image shows both faces of the plate, neither of them with half of the light, the user says which is
    /// meant. Until then the end is where it was.
    void anEndGoesToTheLayerThatIsChosen() {
        const Measurement before = measurements().back();
        const QPoint aside = pointOf(before.places[1].mm) - QPoint(0, 40);
        dragInImage(aside + QPoint(0, 40), aside);  // away from the end behind it, whose handle would be as near
        QTRY_VERIFY_WITH_TIMEOUT(measurements().back() != before, test::kPatience);
        const Measurement apart = measurements().back();
        Look look = document().setup().look;
        look.transferFunction = {1, {{400, 0}, {410, 1}, {590, 1}, {600, 0}}};  // 40 % of the light at the first face
        document().setLook(look);
        waitForImage();
        dragInImage(pointOf(apart.places[1].mm), aside - QPoint(0, 20));
        const auto menu = [&] { return window().findChild<QMenu*>("layers"); };
        QTRY_VERIFY_WITH_TIMEOUT(menu(), test::kPatience);
        QCOMPARE(menu()->actions().size(), 2);
        QVERIFY(measurements().back() == apart);
        menu()->actions()[1]->trigger();
        QVERIFY(std::abs(measurements().back().places[1].mm.x - before.places[0].mm.x) < 0.2);  // the face behind
        menu()->close();
        while (measurements().back() != before)
            document().undo();
    }

    void escapeGivesBackWhatWasDragged() {
        const Measurement before = measurements().back();
        const Text step = document().undoText();
        const QPoint from = pointOf(before.places[1].mm);
        QSignalSpy dropped(&presenter().inImage(), &ui::MarksLayer::dropped);
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, from);
        test::dragOn(viewport(), from + QPoint(0, 30));
        key(Qt::Key_Escape);
        test::dragOn(viewport(), from + QPoint(0, 40));
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, from + QPoint(0, 40));
        QVERIFY(dropped.isEmpty() && measurements().back() == before);
        QCOMPARE(document().undoText(), step);
    }

    /// What the image shows where an end was dropped takes a while to find. Esc until then leaves the end where it was.
    void escapeGivesBackWhatWasDropped() {
        const Measurement before = measurements().back();
        const Text step = document().undoText();
        const QPoint from = pointOf(before.places[1].mm), to = from + QPoint(0, 30);
        dragInImage(from, to);
        key(Qt::Key_Escape);
        QTest::qWait(500);  // longer than it takes
        QVERIFY(measurements().back() == before);
        QCOMPARE(document().undoText(), step);
    }

    /// Only a press and a release at one place is a click: a drag turns the image, also while something is drawn.
    void whileDrawingTheImageStillTurns() {
        const std::size_t before = measurements().size();
        const dvec3 eye = document().setup().camera.eyeMm;
        key(Qt::Key_M);
        const QPoint from = viewport().rect().center();
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, from);
        QTest::mouseMove(&viewport(), from + QPoint(40, 5));
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, from + QPoint(40, 5));
        QVERIFY(document().setup().camera.eyeMm != eye);
        key(Qt::Key_Escape);
        QCOMPARE(measurements().size(), before);
    }

  private:
    /// Shows the face of the plate on which the second place lies, and waits until what hides the first is known.
    void showFromTheRight() {
        document().setView(StandardView::right);
        waitForImage();
        const std::uint64_t id = measurements().back().id;
        const auto& hidden = presenter().inImage().hidden();
        QTRY_VERIFY_WITH_TIMEOUT(hidden.contains(id) && hidden.at(id).places.at(0) && !hidden.at(id).places.at(1),
                                 test::kPatience);
    }
    /// Returns where `placeMm` is seen in the image [px].
    QPoint pointOf(dvec3 placeMm) {
        const ui::ImagePlace image{viewport().size(), QRectF(viewport().rect()), document().setup().camera};
        return ui::seenAt(image, placeMm)->toPoint();
    }
    void dragInImage(QPoint from, QPoint to) {
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, from);
        test::dragOn(viewport(), (from + to) / 2);
        test::dragOn(viewport(), to);
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, to);
    }
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::MarksInImageTest)
#include "marks_in_image_test.moc"
