/// Measuring in the window: two clicks on a slice, a value with its ±, one list, one step to undo each.

#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "app/plan/measured.h"
#include "app/presenters/marks_presenter.h"
#include "app/presenters/slices_presenter.h"
#include "dicom/write/export.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/patience.h"
#include "tests/support/scenes/scenes.h"
#include "ui/text/to_qt.h"

namespace pdr::app {
namespace {

/// HU of a plate of 20 mm across x, whose edges are blurred by 1 mm as a scanner would.
int plateHu(double x) {
    return int(std::lround(40 + 480 * (std::erf((x + 10) / std::sqrt(2.0)) - std::erf((x - 10) / std::sqrt(2.0)))));
}

}  // namespace

class MarksInWindowTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        series_ = folder_.filePath("series");
        const auto plate =
            test::makeVolume({80, 64, 24}, dvec3(1, 1, 2), [](int i, int, int) { return plateHu(i - 39.5); });
        const dicom::ExportFacts facts{"Phantom^Plate", "PLATE", "Test", "Plate", "Made from a formula."};
        const auto written = dicom::writeSeries(*plate, facts, ui::fromQt(series_), noProgress);
        QVERIFY2(written, written ? "" : written.error().text().c_str());
        trial_ = std::make_unique<Trial>();
        trial_->desktop.window().resize(1300, 800);
        trial_->openAndWait(series_);
        const VolumeGeometry& geometry = document().seen()->geometry();
        centre_ = geometry.centreMm();
    }
    void cleanupTestCase() { trial_.reset(); }

    /// M shows the slices, two clicks near the faces of the plate measure its thickness.
    void twoClicksMeasureAPlate() {
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_M);
        QTRY_VERIFY_WITH_TIMEOUT(axial().slice(), test::kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(axial().slice()->plane.size == axial().sizeInPixels(), test::kPatience);
        click(centre_ + dvec3(-9, 3, 0));
        click(centre_ + dvec3(10.8, 3, 0));
        QCOMPARE(measurements().size(), std::size_t(1));
        const auto value = measured(measurements()[0], *document().seen());
        QVERIFY(value);
        QVERIFY2(std::abs(value->value - 20) < 0.3, qPrintable(QString::number(value->value)));
        QVERIFY(std::abs(value->value - 20) <= value->plusMinus.value());
        QVERIFY(isAtEdge(measurements()[0].places[0]) && isAtEdge(measurements()[0].places[1]));
        const auto* list = panel().findChild<QTreeWidget*>();
        QCOMPARE(list->topLevelItemCount(), 1);
        QVERIFY2(list->topLevelItem(0)->text(1).contains(QString::fromUtf8("±")),
                 qPrintable(list->topLevelItem(0)->text(1)));
        click(centre_);  // drawing has ended: the crosshair moves
        QCOMPARE(measurements().size(), std::size_t(1));
    }

    void withAltAPlaceStaysWhereItWasClicked() {
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_M);
        click(centre_ + dvec3(-9, 0, 0), Qt::AltModifier);
        click(centre_ + dvec3(9, 0, 0), Qt::AltModifier);
        const Measurement& measurement = measurements().back();
        QVERIFY(std::abs(measurement.places[0].mm.x - (centre_.x - 9)) < axial().slice()->plane.mmPerPixel);
        QVERIFY(!isAtEdge(measurement.places[0]));
    }

    void anAngleTakesThreeClicks() {
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_A);
        click(centre_ + dvec3(20, 0, 0), Qt::AltModifier);
        click(centre_ + dvec3(20, 15, 0), Qt::AltModifier);
        click(centre_ + dvec3(35, 15, 0), Qt::AltModifier);
        const auto value = measured(measurements().back(), *document().seen());
        QVERIFY(value && std::abs(value->value - 90) < 6 && std::abs(value->value - 90) <= value->plusMinus.value());
    }

    void eachIsOneStepAndUndoBringsItBack() {
        QCOMPARE(measurements().size(), std::size_t(3));
        QCOMPARE(document().undoText(), Text("Undo measuring"));
        const std::vector<Measurement> all = measurements();
        emit panel().removed(all[0].id);
        QCOMPARE(measurements().size(), std::size_t(2));
        QCOMPARE(document().undoText(), Text("Undo removing a measurement"));
        document().undo();
        QVERIFY(measurements() == all);
        emit panel().renamed(all[0].id, "plate");
        QCOMPARE(measurements()[0].name, std::string("plate"));
        QCOMPARE(panel().findChild<QTreeWidget*>()->topLevelItem(0)->text(0), QString("plate"));
        document().undo();
        QVERIFY(measurements() == all);
    }

    void choosingOneMovesTheSlicesThere() {
        const Measurement first = measurements()[0];
        emit panel().selected(first.id);
        QVERIFY(document().plan().navigation.crosshairMm == first.places[0].mm);
    }

    void escapeGivesUp() {
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_M);
        click(centre_);
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_Escape);
        click(centre_ + dvec3(5, 5, 0));
        QCOMPARE(measurements().size(), std::size_t(3));
    }

    /// The measurements belong to the patient.
    void anotherSeriesHasNone() {
        while (document().canUndo())
            document().undo();                                  // else the window asks whether they may be lost
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_M);  // and what is being drawn ends
        trial_->frames.clear();
        trial_->openAndWait(series_);
        QVERIFY(measurements().empty());
        QCOMPARE(panel().findChild<QTreeWidget*>()->topLevelItemCount(), 0);
    }

  private:
    Document& document() { return trial_->desktop.document(); }
    const std::vector<Measurement>& measurements() { return document().plan().measurements; }
    ui::MarksPanel& panel() { return trial_->desktop.presenter<MarksPresenter>().panel(); }
    ui::SliceView& axial() { return trial_->desktop.presenter<SlicesPresenter>().view(AnatomicalPlane::axial); }
    /// Clicks on the axial slice where `placeMm` is seen.
    void click(dvec3 placeMm, Qt::KeyboardModifiers modifiers = {}) {
        const dvec2 pixel = (axial().slice()->plane.pixelAt(placeMm) + 0.5) / axial().devicePixelRatioF();
        QTest::mouseClick(&axial(), Qt::LeftButton, modifiers, QPointF(pixel.x, pixel.y).toPoint());
    }

    QTemporaryDir folder_;
    QString series_;
    std::unique_ptr<Trial> trial_;
    dvec3 centre_{0};
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::MarksInWindowTest)
#include "marks_in_window_test.moc"
