/// The tissue panel for every user: it holds a valid function whatever is pressed, keys reach everything, names
/// describe it, and everything important is visible.

#include <QLineEdit>
#include <QTest>
#include <algorithm>
#include <random>

#include "render/volume/volume.h"
#include "tests/support/desktop/contrast.h"
#include "tests/support/desktop/tissue_hand.h"
#include "ui/theme/theme.h"

namespace pdr::ui {

class TestTissueAccess : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { applyTheme(*qApp, ThemeChoice::dark); }
    void whateverTheHandDoesTheFunctionStaysOne();
    void everyControlIsReachedAndNamed();
    void textAndPointsStandOut();
};

/// Thousands of presses, drags, keys and wheel events on both plots, with changes from outside between them.
void TestTissueAccess::whateverTheHandDoesTheFunctionStaysOne() {
    TissueHand hand;
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
                test::dragOn(plot, place, Qt::LeftButton);
        }
        QVERIFY(hand.panel.transferFunction().check());
        QVERIFY(hand.panel.editor().selection().empty() ||
                hand.panel.editor().selection().back() < hand.panel.editor().points().size());
        QCOMPARE(hand.panel.strip().stops().size(), hand.panel.strip().points().size());
    }
    QVERIFY2(hand.edits > 100 && hand.rests > 50, qPrintable(QString("%1 %2").arg(hand.edits).arg(hand.rests)));
}

void TestTissueAccess::everyControlIsReachedAndNamed() {
    TissueHand hand;
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
    QVERIFY(hand.panel.editor().accessibleDescription().startsWith("selected, -1,000 HU"));
}

void TestTissueAccess::textAndPointsStandOut() {
    TissueHand hand;
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
    QVERIFY2(test::contrast(point, bars) >= 3, qPrintable(QString("%1 on %2").arg(point.name(), bars.name())));
    QVERIFY(test::contrast(point, ground) >= 3);
    const QPalette palette = editor.palette();
    QVERIFY(test::contrast(palette.color(QPalette::WindowText), palette.color(QPalette::Window)) >= 4.5);
    QVERIFY(test::contrast(palette.color(QPalette::Link), palette.color(QPalette::Window)) >= 3);
    hand.panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&hand.panel));
    editor.setFocus();
    QVERIFY(editor.grab().toImage().pixelColor(1, 50) != image.pixelColor(1, 50));
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestTissueAccess)
#include "tissue_access_test.moc"
