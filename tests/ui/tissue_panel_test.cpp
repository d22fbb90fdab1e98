/// The panel of the tissue under mouse and keys: what it emits, what it shows, and that no gesture is left open.

#include <QColorDialog>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <random>

#include "render/volume/volume.h"
#include "ui/dark_theme.h"
#include "ui/tissue/tissue_panel.h"

namespace pdr::ui {

static TransferFunction bone() {
    TransferFunction function{1.2f, std::vector<TransferNode>(4)};
    const float hu[] = {-1000, 150, 400, 1500}, opacity[] = {0, 0, 0.8f, 1};
    for (std::size_t i = 0; i < 4; ++i) {
        function.nodes[i].hu = hu[i];
        function.nodes[i].opacity = opacity[i];
        function.nodes[i].albedo = i < 2 ? vec3(0.8f, 0.1f, 0.1f) : vec3(0.9f, 0.9f, 0.7f);
    }
    return function;
}

/// The panel with a function, and what it emits.
struct Hand {
    Hand() {
        QObject::connect(&panel, &TissuePanel::transferFunctionEdited,
                         [this](const TransferFunction& function, bool moving) {
                             last = function;
                             edits += moving;
                             rests += !moving;
                             panel.setTransferFunction(function);  // as the document tells it
                         });
        panel.setTransferFunction(bone());
        panel.resize(320, 460);
        panel.show();
        emit panel.editor().fitRequested();
    }

    QPoint at(double hu, double value) { return panel.editor().view().at(hu, value).toPoint(); }

    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers keys = {}) {
        QTest::mousePress(&panel.editor(), Qt::LeftButton, keys, from);
        move(panel.editor(), (from + to) / 2, Qt::LeftButton);
        move(panel.editor(), to, Qt::LeftButton);
        QTest::mouseRelease(&panel.editor(), Qt::LeftButton, keys, to);
    }

    static void move(QWidget& widget, QPoint place, Qt::MouseButton button) {
        QMouseEvent event(QEvent::MouseMove, place, widget.mapToGlobal(place), Qt::NoButton, button, {});
        QCoreApplication::sendEvent(&widget, &event);
    }

    template <class Control>
    Control* named(const QString& name) {
        for (Control* control : panel.findChildren<Control*>())
            if (control->accessibleName() == name)
                return control;
        qFatal("there is no control %s", qPrintable(name));
    }

    void choose(const char* box, int index) {
        auto* combo = named<QComboBox>(box);
        combo->setCurrentIndex(index);
        emit combo->activated(index);
    }

    TissuePanel panel;
    TransferFunction last;
    int edits = 0, rests = 0;
};

class TestTissuePanel : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void settersAreSilent();
    void aDragIsOneGesture();
    void whatComesFromOutsideEndsTheDrag();
    void keysNudgeAddAndRemove();
    void typedValuesAreExact();
    void aTypedValueAboveTheAxisMakesRoom();
    void densityScalesTheWholeCurve();
    void shapesBecomeFreePointsWhenOneIsMoved();
    void percentilesNeedAHistogram();
    void coloursHaveStopsOfTheirOwn();
    void aColourIsChosenAndGivenUp();
    void theOtherCurvesAreEditedAlone();
    void theWheelZoomsBothPlots();
    void tooManyNodesAreNotTaken();
    void whateverTheHandDoesTheFunctionStaysOne();
    void everyControlIsReachedAndNamed();
    void textAndPointsStandOut();
};

void TestTissuePanel::initTestCase() {
    applyDarkTheme(*qApp);
}

void TestTissuePanel::settersAreSilent() {
    Hand hand;
    hand.panel.setTransferFunction({2, {{0, 1}}});
    hand.panel.setHistogram(std::make_shared<const Histogram>());
    hand.panel.setHistogram(nullptr);
    hand.panel.setPicking(true);
    QCOMPARE(hand.edits + hand.rests, 0);
}

void TestTissuePanel::aDragIsOneGesture() {
    Hand hand;
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

/// Undo, or a preset, while the mouse is held.
void TestTissuePanel::whatComesFromOutsideEndsTheDrag() {
    Hand hand;
    QTest::mousePress(&hand.panel.editor(), Qt::LeftButton, {}, hand.at(400, 0.8));
    Hand::move(hand.panel.editor(), hand.at(500, 0.8), Qt::LeftButton);
    QVERIFY(hand.edits > 0);
    TransferFunction other = bone();
    other.nodes[3].opacity = 0.9f;
    hand.panel.setTransferFunction(other);
    const int before = hand.edits + hand.rests;
    Hand::move(hand.panel.editor(), hand.at(700, 0.2), Qt::LeftButton);
    QCOMPARE(hand.edits + hand.rests, before);
    QVERIFY(hand.panel.transferFunction() == other);
}

void TestTissuePanel::keysNudgeAddAndRemove() {
    Hand hand;
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
    Hand hand;
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
    Hand hand;
    QTest::mouseClick(&hand.panel.editor(), Qt::LeftButton, {}, hand.at(400, 0.8));
    hand.named<QDoubleSpinBox>("Value of the selected point")->setValue(3);
    QCOMPARE(hand.last.extinctionPerMm, 3.0f);
    QVERIFY(std::abs(hand.last.opacityAt(400) - 1) < 1e-6f);
    QVERIFY(std::abs(3 * hand.last.opacityAt(1500) - 1.2f) < 1e-5f);
    QVERIFY(hand.last.check());
}

void TestTissuePanel::densityScalesTheWholeCurve() {
    Hand hand;
    hand.named<QDoubleSpinBox>("Density at the top of the opacity curve")->setValue(0.6);
    TransferFunction thinner = bone();
    thinner.extinctionPerMm = 0.6f;
    QVERIFY(hand.last == thinner);
    QCOMPARE(hand.rests, 1);
}

void TestTissuePanel::shapesBecomeFreePointsWhenOneIsMoved() {
    Hand hand;
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
    Hand hand;
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

void TestTissuePanel::coloursHaveStopsOfTheirOwn() {
    Hand hand;
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
    Hand hand;
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
    Hand hand;
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
    Hand hand;
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
    Hand hand;
    TransferFunction full;
    for (std::size_t i = 0; i < TransferFunction::kMostNodes; ++i)
        full.nodes.push_back({float(i), i % 2 ? 0.5f : 0.4f});
    hand.panel.setTransferFunction(full);
    QTest::keyClick(&hand.panel.editor(), Qt::Key_Insert);
    QCOMPARE(hand.edits + hand.rests, 0);
    QVERIFY(hand.panel.transferFunction() == full);
    QCOMPARE(hand.panel.editor().points().size(), full.nodes.size());
}

/// Thousands of presses, drags, keys and wheels on both plots, with changes from outside between them.
void TestTissuePanel::whateverTheHandDoesTheFunctionStaysOne() {
    Hand hand;
    std::mt19937 random(17);
    const auto below = [&](int end) { return std::uniform_int_distribution<int>(0, end - 1)(random); };
    const Qt::Key keys[] = {Qt::Key_Left,   Qt::Key_Up,   Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Insert,
                            Qt::Key_Delete, Qt::Key_Plus, Qt::Key_Minus,  Qt::Key_Home,     Qt::Key_A};
    const Qt::KeyboardModifiers modifiers[] = {{}, {}, Qt::ShiftModifier, Qt::ControlModifier};
    for (int step = 0; step < 4000; ++step) {
        PointsPlot& plot = below(2) ? static_cast<PointsPlot&>(hand.panel.editor()) : hand.panel.strip();
        const QPoint place(below(plot.width()), below(plot.height()));
        const Qt::KeyboardModifiers modifier = modifiers[below(4)];
        switch (below(8)) {
            case 0:
                QTest::mousePress(&plot, below(5) ? Qt::LeftButton : Qt::MiddleButton, modifier, place);
                break;
            case 1:
                QTest::mouseRelease(&plot, below(5) ? Qt::LeftButton : Qt::MiddleButton, modifier, place);
                break;
            case 2:
                QTest::keyClick(&plot, keys[below(10)], modifier);
                break;
            case 3:
                if (below(40) == 0)
                    hand.panel.setTransferFunction(below(2) ? bone() : TransferFunction{1, {{40, 0.3f}, {40, 0.7f}}});
                break;
            case 4:
                if (below(40) == 0)
                    hand.choose("Shape of the curve", below(4));
                if (below(40) == 0)
                    hand.named<QComboBox>("Curve")->setCurrentIndex(below(4));
                break;
            default:
                Hand::move(plot, place, Qt::LeftButton);
        }
        QVERIFY(hand.panel.transferFunction().check());
        QVERIFY(hand.panel.editor().selection().empty() ||
                hand.panel.editor().selection().back() < hand.panel.editor().points().size());
        QCOMPARE(hand.panel.strip().stops().size(), hand.panel.strip().points().size());
    }
    QVERIFY2(hand.edits > 100 && hand.rests > 50, qPrintable(QString("%1 %2").arg(hand.edits).arg(hand.rests)));
}

void TestTissuePanel::everyControlIsReachedAndNamed() {
    Hand hand;
    hand.panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&hand.panel));
    for (QWidget* control : hand.panel.findChildren<QWidget*>())
        if (control->focusPolicy() & Qt::TabFocus && control->isVisible() && !qobject_cast<QLineEdit*>(control))
            QVERIFY2(!control->accessibleName().isEmpty(), control->metaObject()->className());
    QSet<QWidget*> reached;
    for (int i = 0; i < 30; ++i) {
        QTest::keyClick(qApp->focusWidget() ? qApp->focusWidget() : &hand.panel, Qt::Key_Tab);
        reached << qApp->focusWidget();
    }
    QVERIFY(reached.contains(&hand.panel.editor()) && reached.contains(&hand.panel.strip()));
    QVERIFY(reached.contains(hand.named<QComboBox>("Curve")) &&
            reached.contains(hand.named<QComboBox>("Shape of the curve")));
    QVERIFY(hand.panel.editor().accessibleDescription().contains("400 HU: 0.96 /mm"));
    QTest::keyClick(&hand.panel.editor(), Qt::Key_PageDown);
    QVERIFY(hand.panel.editor().accessibleDescription().startsWith("selected, -1000 HU"));
}

/// WCAG 2.1, relative luminance: 4.5 for text, 3 for what is not.
static double contrast(const QColor& a, const QColor& b) {
    const auto luminance = [](const QColor& colour) {
        const vec3 light = linearColour(colour);
        return 0.2126 * double(light.x) + 0.7152 * double(light.y) + 0.0722 * double(light.z);
    };
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

/// Against what they stand on: the ground, and the histogram.
void TestTissuePanel::textAndPointsStandOut() {
    Hand hand;
    const Volume volume(VolumeGeometry::aligned({2000, 1, 1}, dvec3(1), dvec3(0)), [] {
        Voxels voxels;
        for (int i = 0; i < 2000; ++i)
            voxels.push_back(std::int16_t(i - 1000));
        return voxels;
    }());
    hand.panel.setHistogram(std::make_shared<const Histogram>(volume));
    CurveEditor& editor = hand.panel.editor();
    editor.clearFocus();
    const QImage image = editor.grab().toImage();
    const QColor point = image.pixelColor(hand.at(150, 0)), bars = image.pixelColor(hand.at(-300, 0.3));
    const QColor ground = image.pixelColor(hand.at(-300, 0.95));
    QVERIFY2(contrast(point, bars) >= 3, qPrintable(QString("%1 on %2").arg(point.name(), bars.name())));
    QVERIFY(contrast(point, ground) >= 3);
    const QPalette palette = editor.palette();
    QVERIFY(contrast(palette.color(QPalette::WindowText), palette.color(QPalette::Window)) >= 4.5);
    QVERIFY(contrast(palette.color(QPalette::Link), palette.color(QPalette::Window)) >= 3);
    hand.panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&hand.panel));
    editor.setFocus();
    QVERIFY(editor.grab().toImage().pixelColor(1, 50) != image.pixelColor(1, 50));
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestTissuePanel)
#include "tissue_panel_test.moc"
