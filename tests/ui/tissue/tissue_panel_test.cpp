/// The tissue panel under mouse and keys: what it emits, what it shows, and that no gesture is left open.

#include <QColorDialog>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>

#include "render/volume/volume.h"
#include "tests/support/desktop/tissue_hand.h"

namespace pdr::ui {

class TestTissuePanel : public QObject {
    Q_OBJECT

  private slots:
    void settersAreSilent();
    void aDragIsOneGesture();
    void whatComesFromOutsideEndsTheDrag();
    void keysNudgeAddAndRemove();
    void typedValuesAreExact();
    void aTypedValueAboveTheAxisMakesRoom();
    void densityScalesTheWholeCurve();
    void shapesBecomeFreePointsWhenOneIsMoved();
    void percentilesNeedAHistogram();
    void stepsFollowTheRangeOfValues();
    void coloursHaveStopsOfTheirOwn();
    void aColourIsChosenAndGivenUp();
    void theOtherCurvesAreEditedAlone();
    void theWheelZoomsBothPlots();
    void tooManyNodesAreNotTaken();
};

void TestTissuePanel::settersAreSilent() {
    TissueHand hand;
    hand.panel.setTransferFunction({2, {{0, 1}}});
    hand.panel.setHistogram(std::make_shared<const Histogram>());
    hand.panel.setHistogram(nullptr);
    hand.panel.setPicking(true);
    QCOMPARE(hand.edits + hand.rests, 0);
}

void TestTissuePanel::aDragIsOneGesture() {
    TissueHand hand;
    hand.drag(hand.at(400, 0.8), hand.at(600, 0.5));
    QVERIFY(hand.edits >= 2);
    QCOMPARE(hand.rests, 1);
    QVERIFY(hand.last.check());
    const CurvePoint point = curveOf(hand.last, TissueChannel::opacity)[2];
    QVERIFY(std::abs(point.hu - 600) < 12 && std::abs(point.value - 0.5f) < 0.02f);
    QVERIFY(glm::length(hand.last.at(400).albedo - bone().at(400).albedo) < 1e-5f);
    QTest::mouseClick(&hand.panel.editor(), Qt::LeftButton, {}, hand.at(-1000, 0.9));
    QCOMPARE(hand.rests, 1);
}

/// An undo or a look arrives while the mouse button is held.
void TestTissuePanel::whatComesFromOutsideEndsTheDrag() {
    TissueHand hand;
    QTest::mousePress(&hand.panel.editor(), Qt::LeftButton, {}, hand.at(400, 0.8));
    test::dragOn(hand.panel.editor(), hand.at(500, 0.8), Qt::LeftButton);
    QVERIFY(hand.edits > 0);
    TransferFunction other = bone();
    other.nodes[3].opacity = 0.9f;
    hand.panel.setTransferFunction(other);
    const int before = hand.edits + hand.rests;
    test::dragOn(hand.panel.editor(), hand.at(700, 0.2), Qt::LeftButton);
    QCOMPARE(hand.edits + hand.rests, before);
    QVERIFY(hand.panel.transferFunction() == other);
}

void TestTissuePanel::keysNudgeAddAndRemove() {
    TissueHand hand;
    CurveEditor& editor = hand.panel.editor();
    editor.setRange(0, 200);  // a pixel is less than a unit
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&editor, Qt::Key_PageDown);
    QCOMPARE(editor.selection(), CurveSelection{2});
    QTest::keyClick(&editor, Qt::Key_Right);
    QTest::keyClick(&editor, Qt::Key_Right, Qt::ShiftModifier);
    QTest::keyClick(&editor, Qt::Key_Up);
    QCOMPARE(editor.points()[2].hu, 411.0f);
    QVERIFY(std::abs(hand.last.opacityAt(411) - 0.81f) < 1e-6f);
    QCOMPARE(hand.rests, 0);
    QTRY_COMPARE(hand.rests, 1);  // three keys, one step
    QTest::keyClick(&editor, Qt::Key_Insert);
    QCOMPARE(editor.points().size(), std::size_t(5));
    QCOMPARE(hand.rests, 2);
    QTest::keyClick(&editor, Qt::Key_Delete);
    QCOMPARE(editor.points().size(), std::size_t(4));
    QTest::keyClick(&editor, Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(editor.selection().size(), std::size_t(4));
    QTest::keyClick(&editor, Qt::Key_Left);
    QTest::keyClick(&editor, Qt::Key_Delete);  // a nudge that has not rested is a step of its own
    QCOMPARE(editor.points().size(), std::size_t(1));
    QCOMPARE(hand.rests, 5);
    QTest::keyClick(&editor, Qt::Key_Delete);
    QCOMPARE(hand.rests, 5);
}

void TestTissuePanel::typedValuesAreExact() {
    TissueHand hand;
    auto* hu = hand.named<QDoubleSpinBox>("Place of the selected point");
    auto* value = hand.named<QDoubleSpinBox>("Value of the selected point");
    QVERIFY(!hu->isEnabled());
    QTest::mouseClick(&hand.panel.editor(), Qt::LeftButton, {}, hand.at(400, 0.8));
    QVERIFY(hu->isEnabled());
    QCOMPARE(hu->value(), 400.0);
    QVERIFY(std::abs(value->value() - 0.96) < 1e-4);
    QCOMPARE(value->suffix(), QString(" /mm"));
    hu->setValue(317);
    QCOMPARE(hand.last.nodes[2].hu, 317.0f);
    value->setValue(0.3);
    QVERIFY(std::abs(hand.last.nodes[2].opacity * hand.last.extinctionPerMm - 0.3f) < 1e-6f);
    hu->setValue(-9000);  // the point before stays where it is
    QCOMPARE(hand.last.nodes[2].hu, 150.0f);
    QCOMPARE(hu->value(), 150.0);
}

void TestTissuePanel::aTypedValueAboveTheAxisMakesRoom() {
    TissueHand hand;
    QTest::mouseClick(&hand.panel.editor(), Qt::LeftButton, {}, hand.at(400, 0.8));
    hand.named<QDoubleSpinBox>("Value of the selected point")->setValue(3);
    QCOMPARE(hand.last.extinctionPerMm, 3.0f);
    QVERIFY(std::abs(hand.last.opacityAt(400) - 1) < 1e-6f);
    QVERIFY(std::abs(3 * hand.last.opacityAt(1500) - 1.2f) < 1e-5f);
    QVERIFY(hand.last.check());
}

void TestTissuePanel::densityScalesTheWholeCurve() {
    TissueHand hand;
    hand.named<QDoubleSpinBox>("Density at the top of the opacity curve")->setValue(0.6);
    TransferFunction thinner = bone();
    thinner.extinctionPerMm = 0.6f;
    QVERIFY(hand.last == thinner);
    QCOMPARE(hand.rests, 1);
}

void TestTissuePanel::shapesBecomeFreePointsWhenOneIsMoved() {
    TissueHand hand;
    auto* kinds = hand.named<QComboBox>("Shape of the curve");
    hand.choose("Shape of the curve", 2);
    QCOMPARE(hand.rests, 1);
    const float from = firstAt(curveOf(hand.last, TissueChannel::opacity), 0.5f);
    QCOMPARE(hand.named<QDoubleSpinBox>("From of the curve")->value(), double(from));
    hand.named<QDoubleSpinBox>("From of the curve")->setValue(250);
    QCOMPARE(hand.last.opacityAt(249), 0.0f);
    QCOMPARE(hand.last.opacityAt(250), 1.0f);
    QCOMPARE(kinds->currentIndex(), 2);
    hand.drag(hand.at(250, 1), hand.at(600, 0.5));
    QCOMPARE(kinds->currentIndex(), 0);
    hand.choose("Shape of the curve", 3);
    hand.panel.setTransferFunction(bone());
    QCOMPARE(kinds->currentIndex(), 0);
}

void TestTissuePanel::percentilesNeedAHistogram() {
    TissueHand hand;
    auto* kinds = hand.named<QComboBox>("Shape of the curve");
    const auto enabled = [&] { return bool(kinds->model()->flags(kinds->model()->index(4, 0)) & Qt::ItemIsEnabled); };
    QVERIFY(!enabled());
    const Volume volume(VolumeGeometry::aligned({100, 1, 1}, dvec3(1), dvec3(0)), Voxels(100, 70));
    hand.panel.setHistogram(std::make_shared<const Histogram>(volume));
    QVERIFY(enabled());
    hand.choose("Shape of the curve", 4);
    hand.named<QDoubleSpinBox>("From of the curve")->setValue(25);
    hand.named<QDoubleSpinBox>("To of the curve")->setValue(75);
    QCOMPARE(hand.last.opacityAt(69.75f), 0.0f);
    QCOMPARE(hand.last.opacityAt(70.25f), 1.0f);
}

/// Values from 0 to 20 have places between whole numbers, and those of 65,536 voxels no steps of a voxel.
void TestTissuePanel::stepsFollowTheRangeOfValues() {
    TissueHand hand;
    const auto* place = hand.named<QDoubleSpinBox>("Place of the selected point");
    QCOMPARE(place->singleStep(), 1.0);
    const auto show = [&](const ValueUnit& unit, std::int16_t highest) {
        const Volume volume(VolumeGeometry::aligned({2, 1, 1}, dvec3(1), dvec3(0)), Voxels{0, highest});
        hand.panel.setTransferFunction({1, {{0, 0}, {float(highest), 1}}});
        hand.panel.setValues(unit);
        hand.panel.setHistogram(std::make_shared<const Histogram>(volume));
    };
    show(ValueUnit::other("g/ml", 20.0 / 32767), 32767);
    QCOMPARE(place->singleStep(), 0.01);
    QCOMPARE(place->decimals(), 4);
    show(ValueUnit::other("g/ml"), 20);
    QCOMPARE(place->singleStep(), 0.01);
    QCOMPARE(place->decimals(), 2);
    hand.choose("Shape of the curve", 2);
    auto* from = hand.named<QDoubleSpinBox>("From of the curve");
    QCOMPARE(from->singleStep(), 0.1);
    from->setValue(3.4);
    QVERIFY(hand.last.opacityAt(3.3f) == 0 && hand.last.opacityAt(3.5f) == 1);
    // By hand and by keys
    show(ValueUnit::other("g/ml"), 20);
    CurveEditor& editor = hand.panel.editor();
    QTest::mouseClick(&editor, Qt::LeftButton, Qt::NoModifier, hand.at(7.5, 0.375));
    QVERIFY(std::abs(place->value() - 7.5) < 0.15 && place->value() != std::round(place->value()));
    const double before = place->value();
    QTest::keyClick(&editor, Qt::Key_Right);
    QVERIFY(place->value() > before && place->value() < before + 0.2);
    QVERIFY(editor.accessibleDescription().contains(QString::number(place->value(), 'f', 2) + " g/ml"));
}

void TestTissuePanel::coloursHaveStopsOfTheirOwn() {
    TissueHand hand;
    ColourStrip& strip = hand.panel.strip();
    QCOMPARE(strip.stops().size(), std::size_t(2));
    const auto x = [&](double hu) { return QPoint(int(strip.view().x(hu)), strip.height() - 8); };
    QTest::mouseClick(&strip, Qt::LeftButton, Qt::ControlModifier, x(900));
    QCOMPARE(strip.stops().size(), std::size_t(3));
    QVERIFY(glm::length(strip.stops()[2].albedo - vec3(0.9f, 0.9f, 0.7f)) < 1e-6f);
    strip.setColour(2, Qt::blue, false);
    QVERIFY(glm::length(hand.last.at(2000).albedo - vec3(0, 0, 1)) < 1e-3f);
    for (float hu = -1200; hu < 2000; hu += 13)
        QVERIFY(std::abs(hand.last.opacityAt(hu) - bone().opacityAt(hu)) < 1e-5f);
    QTest::keyClick(&strip, Qt::Key_Delete);
    QCOMPARE(strip.stops().size(), std::size_t(2));
    QVERIFY(glm::length(hand.last.at(2000).albedo - vec3(0.9f, 0.9f, 0.7f)) < 1e-6f);
    QVERIFY(curveOf(hand.last, TissueChannel::opacity) == curveOf(bone(), TissueChannel::opacity));
}

void TestTissuePanel::aColourIsChosenAndGivenUp() {
    TissueHand hand;
    QTest::keyClick(&hand.panel.strip(), Qt::Key_PageDown);
    QTest::keyClick(&hand.panel.strip(), Qt::Key_Return);
    auto* dialog = hand.panel.findChild<QColorDialog*>();
    QVERIFY(dialog);
    dialog->setCurrentColor(Qt::green);
    QCOMPARE(hand.edits, 1);
    QVERIFY(hand.last.at(-1000).albedo.y > 0.9f);
    dialog->reject();
    QCOMPARE(hand.rests, 1);
    QVERIFY(glm::length(hand.last.at(-1000).albedo - bone().at(-1000).albedo) < 0.01f);
}

void TestTissuePanel::theOtherCurvesAreEditedAlone() {
    TissueHand hand;
    for (const int channel : {1, 2, 3}) {
        hand.named<QComboBox>("Curve")->setCurrentIndex(channel);
        CurveEditor& editor = hand.panel.editor();
        const TransferFunction before = hand.panel.transferFunction();
        QTest::mouseClick(&editor, Qt::LeftButton, Qt::ControlModifier, hand.at(300, 0.75 * editor.view().top()));
        for (float hu = -1200; hu < 2000; hu += 13) {
            QVERIFY(std::abs(hand.last.opacityAt(hu) - before.opacityAt(hu)) < 1e-5f);
            QVERIFY(glm::length(hand.last.at(hu).albedo - before.at(hu).albedo) < 1e-5f);
        }
        QVERIFY(hand.last != before && hand.last.check());
    }
    hand.named<QComboBox>("Curve")->setCurrentIndex(0);
    QVERIFY(hand.last.at(300).specular.x > 0.7f && hand.last.at(300).emission.x > 0.7f);
}

void TestTissuePanel::theWheelZoomsBothPlots() {
    TissueHand hand;
    CurveEditor& editor = hand.panel.editor();
    const QPointF place = hand.at(400, 0.5);
    const double hu = editor.view().hu(place.x());
    const auto wheel = [&](Qt::KeyboardModifiers keys) {
        QWheelEvent event(place, editor.mapToGlobal(place), {}, {0, 360}, Qt::NoButton, keys, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&editor, &event);
    };
    const double range = editor.view().highHu() - editor.view().lowHu();
    wheel({});
    QVERIFY(editor.view().highHu() - editor.view().lowHu() < range / 1.9);
    QVERIFY(std::abs(editor.view().hu(place.x()) - hu) < 1e-6);
    QVERIFY(std::abs(hand.panel.strip().view().lowHu() - editor.view().lowHu()) < 1e-6);
    QCOMPARE(hand.panel.strip().view().x(hu), editor.view().x(hu));
    wheel(Qt::ShiftModifier);
    QVERIFY(editor.view().top() < 0.6);
    QCOMPARE(hand.edits + hand.rests, 0);
    QTest::keyClick(&editor, Qt::Key_Home);
    QVERIFY(editor.view().highHu() - editor.view().lowHu() > range / 1.1);
}

void TestTissuePanel::tooManyNodesAreNotTaken() {
    TissueHand hand;
    TransferFunction full;
    for (std::size_t i = 0; i < TransferFunction::kMostNodes; ++i)
        full.nodes.push_back({float(i), i % 2 ? 0.5f : 0.4f});
    hand.panel.setTransferFunction(full);
    QTest::keyClick(&hand.panel.editor(), Qt::Key_Insert);
    QCOMPARE(hand.edits + hand.rests, 0);
    QVERIFY(hand.panel.transferFunction() == full);
    QCOMPARE(hand.panel.editor().points().size(), full.nodes.size());
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestTissuePanel)
#include "tissue_panel_test.moc"
