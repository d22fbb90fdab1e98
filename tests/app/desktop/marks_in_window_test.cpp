/// Measuring in the window: two clicks on a slice, a value with its ±, one list, one step to undo each.

#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/plan/measured.h"
#include "app/presenters/mark_profile.h"
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

    /// The key gives a slice the keyboard; there the crosshair is the pointer.
    void keysAloneMeasure() {
        const std::size_t before = measurements().size();
        trial_->desktop.window().viewport().setFocus();
        document().moveCrosshair(centre_);
        const double voxelMm = document().scan()->geometry().spacingMm().x;
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_M);
        ui::SliceView& axial = trial_->desktop.presenter<SlicesPresenter>().view(AnatomicalPlane::axial);
        QCOMPARE(trial_->desktop.window().focusWidget(), &axial);
        QTRY_VERIFY_WITH_TIMEOUT(axial.slice(), test::kPatience);
        QTest::keyClick(&axial, Qt::Key_Return, Qt::AltModifier);
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(&axial, Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&axial, Qt::Key_Return, Qt::AltModifier);
        QCOMPARE(measurements().size(), before + 1);
        const std::vector<measure::Place>& places = measurements().back().places;
        QVERIFY(glm::distance(places[0].mm, centre_) < 1e-6);
        QVERIFY(glm::distance(places[1].mm, centre_ + dvec3(3 * voxelMm, 0, 0)) < 1e-6);
        document().undo();
    }

    void anAngleTakesThreeClicks() {
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_A);
        click(centre_ + dvec3(20, 0, 0), Qt::AltModifier);
        click(centre_ + dvec3(20, 15, 0), Qt::AltModifier);
        click(centre_ + dvec3(35, 15, 0), Qt::AltModifier);
        const auto value = measured(measurements().back(), *document().seen());
        QVERIFY(value && std::abs(value->value - 90) < 6 && std::abs(value->value - 90) <= value->plusMinus.value());
    }

    /// Lines are taken as they were drawn, each on its own.
    void twoLinesTakeFourClicks() {
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_A, Qt::ShiftModifier);
        for (const dvec3& place : {dvec3(0, 0, 0), dvec3(20, 0, 0), dvec3(0, 10, 0), dvec3(-10, 27.3, 0)})
            click(centre_ + place, Qt::AltModifier);
        QCOMPARE(measurements().back().kind, MeasureKind::lines);
        const auto value = measured(measurements().back(), *document().seen());
        QVERIFY2(value && std::abs(value->value - 120) < 6, qPrintable(QString::number(value->value)));
        document().undo();
    }

    /// Its places stay where they were clicked, and its middle takes the ball along.
    void aBallSaysTheMeanInIt() {
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_O);
        click(centre_ + dvec3(0, -5, 0));
        click(centre_ + dvec3(0, -11, 0));
        QCOMPARE(measurements().back().kind, MeasureKind::ball);
        const auto value = measured(measurements().back(), *document().seen());
        QVERIFY(value && std::abs(value->value - 1000) < 2 && value->region->count > 300);
        QVERIFY(shown(int(measurements().size()) - 1, 1).contains("HU"));
        QVERIFY(!isAtEdge(measurements().back().places[0]) && !isAtEdge(measurements().back().places[1]));
        drag(centre_ + dvec3(0, -5, 0), centre_ + dvec3(0, 1, 0));
        const Measurement& moved = measurements().back();
        QVERIFY(std::abs(glm::distance(moved.places[0].mm, moved.places[1].mm) - 6) < 0.5);
        QVERIFY(glm::distance(moved.places[0].mm, centre_ + dvec3(0, 1, 0)) < 0.5);
        document().undo();
        document().undo();
    }

    /// It stays in the slice of its first click, and its axes stay perpendicular.
    void anEllipseSaysTheMeanInItsSlice() {
        const std::size_t before = measurements().size();
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_O, Qt::ShiftModifier);
        click(centre_);
        click(centre_ + dvec3(6, 0, 0));
        showAxialAt(centre_ + dvec3(0, 0, 4));
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

    /// Its corners go to edges; a click on the first one closes it, and a double click does not fill the window.
    void aPolygonMeasuresTheFaceOfThePlate() {
        const std::size_t before = measurements().size();
        const auto begin = [&] { QTest::keyClick(&trial_->desktop.window(), Qt::Key_M, Qt::ShiftModifier); };
        begin();
        for (const dvec3& corner : {dvec3(-9, -8, 0), dvec3(10.8, -8, 0), dvec3(30, 20, 0)})
            click(centre_ + corner);
        QTest::keyClick(&axial(), Qt::Key_Backspace);
        click(centre_ + dvec3(10.8, 7, 0));
        click(centre_ + dvec3(-9, 7, 0));
        QCOMPARE(measurements().size(), before);
        click(drawnFirst());
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
        const auto layout = trial_->desktop.window().views().layout();
        QTest::mouseDClick(&axial(), Qt::LeftButton, {}, pointOf(centre_ + dvec3(5, 5, 0)));
        QTest::mouseRelease(&axial(), Qt::LeftButton, {}, pointOf(centre_ + dvec3(5, 5, 0)));
        QVERIFY(trial_->desktop.window().views().layout() == layout && axial().width() < 1000);
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
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_M, Qt::ShiftModifier);
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

    /// What a label says is typed at once; its HU are in the list. Two steps: it was marked, and named.
    void aLabelIsTypedWhereItWasClicked() {
        const std::size_t before = measurements().size();
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_I);
        click(centre_);
        QCOMPARE(measurements().size(), before + 1);
        QCOMPARE(document().undoText(), Text("Undo marking a place"));
        QVERIFY2(shown(int(before), 1).endsWith(" HU"), qPrintable(shown(int(before), 1)));
        auto* line = panel().findChild<QLineEdit*>();
        QVERIFY(line && line->isVisible());
        QTest::keyClicks(line, "nerve");
        QTest::keyClick(line, Qt::Key_Return);
        QTRY_COMPARE(measurements().back().name, std::string("nerve"));
        QCOMPARE(marks().back().text, QString("nerve"));
        QCOMPARE(document().undoText(), Text("Undo naming a measurement"));
        document().undo();
        QCOMPARE(document().undoText(), Text("Undo marking a place"));
        document().undo();
        QCOMPARE(measurements().size(), before);
    }

    /// A plan with a longer name could not be opened again.
    void aNameIsNoLongerThanAFileHolds() {
        emit panel().renamed(measurements()[0].id, QString::fromUtf8("ä").repeated(500));
        QVERIFY(measurements()[0].name.size() <= kLongestName && measurements()[0].name.size() > kLongestName - 4);
        document().undo();
    }

    /// Once from either side: each face of the plate is where the ray under the pointer meets its edge.
    void twoClicksOnTheImageMeasureThePlate() {
        const std::size_t before = measurements().size();
        const auto& looks = document().looks().fitted();
        document().chooseLook(int(std::ranges::find(looks, "Bone", &NamedLook::name) - looks.begin()));
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_M);
        for (const StandardView side : {StandardView::left, StandardView::right}) {
            document().setView(side);
            trial_->waitForNewest();
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
        const auto& hidden = trial_->desktop.presenter<MarksPresenter>().inImage().hidden();
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
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_M);
        const QPoint from = viewport().rect().center();
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, from);
        QTest::mouseMove(&viewport(), from + QPoint(40, 5));
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, from + QPoint(40, 5));
        QVERIFY(document().setup().camera.eyeMm != eye);
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_Escape);
        const auto undoToMeasuring = [&] {
            while (document().undoText() != Text("Undo measuring"))
                document().undo();
        };
        undoToMeasuring();
        document().undo();  // the one that was picked
        QCOMPARE(measurements().size(), before - 1);
        undoToMeasuring();
    }

    void eachIsOneStepAndUndoBringsItBack() {
        QCOMPARE(measurements().size(), std::size_t(3));
        QCOMPARE(list().topLevelItemCount(), 3);  // undo goes through the list, too
        QCOMPARE(marks().size(), std::size_t(3));
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

    /// From outside the plate into it and out again, with half levels between its HU and those around it.
    void aDistanceShowsTheHuAlongIt() {
        auto* chart = panel().findChild<ui::ProfileChart*>();
        emit panel().selected(measurements()[0].id);
        QVERIFY(chart && !chart->isHidden());
        QVERIFY2(chart->accessibleDescription().startsWith("From 40 to 1,000 HU over "),
                 qPrintable(chart->accessibleDescription()));
        const auto shown = profileOf(measurements()[0], *document().seen());
        QVERIFY(shown && shown->halfLevels[0] && shown->halfLevels[1]);
        for (const std::optional<double>& level : shown->halfLevels)
            QVERIFY2(std::abs(*level - 520) < 60, qPrintable(QString::number(*level)));
        QVERIFY(std::abs(shown->samples.front().mm + 5) < 1e-9);
        QVERIFY(std::abs(shown->samples.back().mm - shown->lengthMm - 5) < 1e-9);
        const auto& samples = shown->samples;
        const auto inside = std::ranges::find_if(samples, [](const auto& each) { return each.mm > 8; });
        QVERIFY(inside->hu > 990 && samples.front().hu < 60 && samples.back().hu < 60);
        const auto other = std::ranges::find_if(
            measurements(), [](const Measurement& one) { return one.kind != MeasureKind::distance; });
        emit panel().selected(other->id);
        QVERIFY(chart->isHidden());
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
    ui::Viewport& viewport() { return trial_->desktop.window().viewport(); }
    QTreeWidget& list() { return *panel().findChild<QTreeWidget*>(); }
    QString shown(int row, int column) { return list().topLevelItem(row)->text(column); }
    const std::vector<ui::ShownMark>& marks() { return trial_->desktop.presenter<MarksPresenter>().inImage().marks(); }
    QPoint pointOf(dvec3 placeMm) {
        const dvec2 pixel = (axial().slice()->plane.pixelAt(placeMm) + 0.5) / axial().devicePixelRatioF();
        return QPointF(pixel.x, pixel.y).toPoint();
    }
    void drag(dvec3 fromMm, dvec3 toMm) {
        QTest::mousePress(&axial(), Qt::LeftButton, {}, pointOf(fromMm));
        for (const double share : {0.5, 1.0})
            QTest::mouseMove(&axial(), pointOf(glm::mix(fromMm, toMm, share)));
        QTest::mouseRelease(&axial(), Qt::LeftButton, {}, pointOf(toMm));
    }
    /// The first place of a polygon that was begun 9 mm to the right of the middle: the edge at 10 mm.
    dvec3 drawnFirst() const { return centre_ + dvec3(-10, -8, 0); }
    void showAxialAt(dvec3 placeMm) {
        document().moveCrosshair(placeMm);
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(axial().slice()->plane.depthMm(placeMm)) < 0.1, test::kPatience);
    }
    /// Clicks on the axial slice where `placeMm` is seen.
    void click(dvec3 placeMm, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(&axial(), Qt::LeftButton, modifiers, pointOf(placeMm));
    }

    QTemporaryDir folder_;
    QString series_;
    std::unique_ptr<Trial> trial_;
    dvec3 centre_{0};
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::MarksInWindowTest)
#include "marks_in_window_test.moc"
