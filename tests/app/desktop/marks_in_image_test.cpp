/// Measuring on the image: places that are picked, dragged, and hidden.

#include <algorithm>
#include <cmath>

#include "app/plan/measured.h"
#include "tests/support/desktop/plate_trial.h"

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
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::MarksInImageTest)
#include "marks_in_image_test.moc"
