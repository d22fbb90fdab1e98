/// Measuring in the window: two clicks on a slice, a value with its ±, one list, one step to undo each.

#include <QLineEdit>
#include <algorithm>

#include "app/plan/measured.h"
#include "app/presenters/mark_profile.h"
#include "tests/support/desktop/plate_trial.h"

namespace pdr::app {

class MarksInWindowTest : public QObject, PlateTrial {
    Q_OBJECT

  private slots:
    void initTestCase() { begin(); }
    void cleanupTestCase() { trial_.reset(); }

    /// M shows the slices, two clicks near the faces of the plate measure its thickness.
    void twoClicksMeasureAPlate() {
        window().views().setLayout(ViewLayout::image);
        key(Qt::Key_M);
        QVERIFY(window().views().showsSlices());
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
        key(Qt::Key_M);
        click(centre_ + dvec3(-9, 0, 0), Qt::AltModifier);
        click(centre_ + dvec3(9, 0, 0), Qt::AltModifier);
        const Measurement& measurement = measurements().back();
        QVERIFY(std::abs(measurement.places[0].mm.x - (centre_.x - 9)) < axial().slice()->plane.mmPerPixel);
        QVERIFY(!isAtEdge(measurement.places[0]));
    }

    /// The key gives a slice the keyboard; there the crosshair is the pointer.
    void keysAloneMeasure() {
        const std::size_t before = measurements().size();
        viewport().setFocus();
        document().moveCrosshair(centre_);
        const double voxelMm = document().scan()->geometry().spacingMm().x;
        key(Qt::Key_M);
        QCOMPARE(window().focusWidget(), &axial());
        QTest::keyClick(&axial(), Qt::Key_Return, Qt::AltModifier);
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(&axial(), Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&axial(), Qt::Key_Return, Qt::AltModifier);
        QCOMPARE(measurements().size(), before + 1);
        const std::vector<measure::Place>& places = measurements().back().places;
        QVERIFY(glm::distance(places[0].mm, centre_) < 1e-6);
        QVERIFY(glm::distance(places[1].mm, centre_ + dvec3(3 * voxelMm, 0, 0)) < 1e-6);
        document().undo();
    }

    void anAngleTakesThreeClicks() {
        key(Qt::Key_A);
        click(centre_ + dvec3(20, 0, 0), Qt::AltModifier);
        click(centre_ + dvec3(20, 15, 0), Qt::AltModifier);
        click(centre_ + dvec3(35, 15, 0), Qt::AltModifier);
        const auto value = measured(measurements().back(), *document().seen());
        QVERIFY(value && std::abs(value->value - 90) < 6 && std::abs(value->value - 90) <= value->plusMinus.value());
    }

    /// Lines are taken as they were drawn, each on its own.
    void twoLinesTakeFourClicks() {
        key(Qt::Key_A, Qt::ShiftModifier);
        for (const dvec3& place : {dvec3(0, 0, 0), dvec3(20, 0, 0), dvec3(0, 10, 0), dvec3(-10, 27.3, 0)})
            click(centre_ + place, Qt::AltModifier);
        QCOMPARE(measurements().back().kind, MeasureKind::lines);
        const auto value = measured(measurements().back(), *document().seen());
        QVERIFY2(value && std::abs(value->value - 120) < 6, qPrintable(QString::number(value->value)));
        document().undo();
    }

    /// Its places stay where they were clicked, and its middle takes the ball along.
    void aBallSaysTheMeanInIt() {
        key(Qt::Key_O);
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

    /// What a label says is typed at once; its HU are in the list. Two steps: it was marked, and named.
    void aLabelIsTypedWhereItWasClicked() {
        const std::size_t before = measurements().size();
        key(Qt::Key_I);
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
        QCOMPARE(shown(0, 0), QString("plate"));
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
        key(Qt::Key_M);
        click(centre_);
        key(Qt::Key_Escape);
        click(centre_ + dvec3(5, 5, 0));
        QCOMPARE(measurements().size(), std::size_t(3));
    }

    /// What was dragged goes back, whatever the hand does until it lets go.
    void escapeGivesBackWhatWasDragged() {
        const std::vector<Measurement> all = measurements();
        showAxialAt(all[0].places[0].mm);
        const QPoint from = pointOn(axial(), all[0].places[0].mm);
        test::dragOn(axial(), from, Qt::NoButton);  // hovers
        QCOMPARE(axial().cursor().shape(), Qt::SizeAllCursor);
        QTest::mousePress(&axial(), Qt::LeftButton, {}, from);
        test::dragOn(axial(), from + QPoint(20, 0));
        QVERIFY(measurements() != all);
        key(Qt::Key_Escape);
        QVERIFY(measurements() == all);
        test::dragOn(axial(), from + QPoint(40, 0));
        QTest::mouseRelease(&axial(), Qt::LeftButton, {}, from + QPoint(40, 0));
        QVERIFY(measurements() == all);
    }

    /// The measurements belong to the patient.
    void anotherSeriesHasNone() {
        while (document().canUndo())
            document().undo();  // else the window asks whether they may be lost
        key(Qt::Key_M);         // and what is being drawn ends
        open();
        QVERIFY(measurements().empty());
        QCOMPARE(list().topLevelItemCount(), 0);
    }
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::MarksInWindowTest)
#include "marks_in_window_test.moc"
