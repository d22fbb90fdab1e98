/// What users expect of a window: keys with one meaning, a keyboard focus that returns, wheels that change nothing in
/// passing, a context menu, and messages and remarks that do not grow.

#include <QMenuBar>
#include <QMimeData>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/support/desktop/named_widget.h"
#include "tests/support/desktop/the.h"
#include "tests/support/desktop/whole_window.h"
#include "ui/looks/look_panel.h"
#include "ui/looks/visible_row.h"
#include "ui/manual/manual_window.h"
#include "ui/text/language.h"
#include "ui/window/main_window.h"

namespace pdr::ui {

class TestWindowHabits : public QObject {
    Q_OBJECT

  private slots:
    void noTwoThingsHaveTheSameMnemonic_data();
    void noTwoThingsHaveTheSameMnemonic();
    void theKeyboardComesBackAfterTheKeys();
    void aWheelInPassingChangesNothing();
    void whatIsSaidOfALookMovesNoControl();
    void longRemarksEndInDots();
    void aMessageTakesTwoLinesAndTheRestWhenAsked();
    void theRightButtonOffersWhatOneDoesMost();
    void keysOfOtherProgramsWorkHere();
    void moreThanOneFolderIsSaid();
};

static void activate(MainWindow& window) {
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    window.viewport().setFocus();
}

/// Returns the mnemonic letter of a text; 0: there is none.
static QChar mnemonicOf(const QString& text) {
    const QKeySequence keys = QKeySequence::mnemonic(text);
    return keys.isEmpty() ? QChar() : QChar(keys[0].key()).toUpper();
}

/// Returns the texts in the menu bar and the visible window that share a mnemonic, e.g. "Cut, Camera".
static QStringList collisions(const MainWindow& window) {
    QMap<QChar, QStringList> texts;
    for (const QAction* menu : window.findChild<QMenuBar*>()->actions())
        texts[mnemonicOf(menu->text())] << menu->text();
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        const auto* label = qobject_cast<const QLabel*>(widget);
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const QString text = label && label->buddy() ? label->text() : button ? button->text() : QString();
        if (widget->isVisible() && !mnemonicOf(text).isNull())
            texts[mnemonicOf(text)] << text;
    }
    texts.remove(QChar());
    QStringList found;
    for (const QStringList& same : texts)
        if (same.size() > 1)
            found << same.join(", ");
    return found;
}

void TestWindowHabits::noTwoThingsHaveTheSameMnemonic_data() {
    QTest::addColumn<QString>("language");
    for (const QString& code : languages())
        QTest::newRow(qPrintable(code)) << code;
}

void TestWindowHabits::noTwoThingsHaveTheSameMnemonic() {
    QFETCH(QString, language);
    speak(*qApp, language);
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    window.resize(1800, 1400);
    activate(window);
    window.start().show();
    QTest::keyClick(&window, Qt::Key_F4);
    QCOMPARE(collisions(window).join("; "), QString());
    window.start().hide();
    for (const Qt::Key editor : {Qt::Key_F5, Qt::Key_F7, Qt::Key_F8, Qt::Key_F9}) {
        QTest::keyClick(&window, editor);
        QCOMPARE(collisions(window).join("; "), QString());
    }
    speak(*qApp, "en");
}

void TestWindowHabits::theKeyboardComesBackAfterTheKeys() {
    MainWindow window;
    activate(window);
    for (const Qt::Key end : {Qt::Key_Escape, Qt::Key_H}) {
        QTest::keyClick(&window.viewport(), Qt::Key_H);
        QVERIFY(window.findChild<KeysOverlay*>()->isVisible());
        QTest::keyClick(window.findChild<KeysOverlay*>(), end);
        QVERIFY(!window.findChild<KeysOverlay*>()->isVisible());
        QVERIFY(window.viewport().hasFocus());
    }
}

static void wheelOver(QWidget& widget) {
    const QPointF middle = widget.rect().center();
    QWheelEvent event(middle, widget.mapToGlobal(middle), {}, {0, -240}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&widget, &event);
}

void TestWindowHabits::aWheelInPassingChangesNothing() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    window.resize(1400, 900);
    activate(window);
    test::the<LookPanel>(window).setEnabled(true);
    auto& peel = test::named<QDoubleSpinBox>(window, "Thickness removed");
    auto& brightness = test::named<QSlider>(window, "Brightness");
    peel.setValue(5);
    wheelOver(peel);
    wheelOver(brightness);
    QCOMPARE(peel.value(), 5.0);
    QCOMPARE(brightness.value(), 0);
    QVERIFY(window.viewport().hasFocus());
    peel.setFocus();
    wheelOver(peel);
    QVERIFY(peel.value() < 5);
}

void TestWindowHabits::whatIsSaidOfALookMovesNoControl() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    window.resize(1400, 900);
    activate(window);
    const auto& brightness = test::named<QSlider>(window, "Brightness");
    const auto& part = test::named<QComboBox>(window, "Part that is shown");
    const auto places = [&] { return std::pair(brightness.mapTo(&window, QPoint()), part.mapTo(&window, QPoint())); };
    const auto before = places();
    test::the<LookPanel>(window).setDoesNotShow("Thin bone has false holes.");
    test::the<VisibleRow>(window).setNotShown("Only bones are shown, as far as they hold dense bone.");
    QCoreApplication::processEvents();
    QVERIFY(places() == before);
}

/// Remarks are cut off in a narrow window, and their tool tip shows all of them.
void TestWindowHabits::longRemarksEndInDots() {
    MainWindow window;
    window.resize(860, 640);
    activate(window);
    const QString remark = QString("a long remark ").repeated(20).trimmed();
    window.accuracyStatus().setRemarks({remark});
    window.accuracyStatus().setLimit("Voxel size 0.9 x 0.9 x 0.4 mm");
    window.status().showForAWhile("saved as " + QString("/a/long/folder").repeated(12));
    QCoreApplication::processEvents();
    int dotted = 0;
    for (const QLabel* label : window.accuracyStatus().findChildren<QLabel*>()) {
        const bool whole = label->fontMetrics().horizontalAdvance(label->text()) <= label->width();
        QVERIFY2(whole || qobject_cast<const ElidedLabel*>(label), qPrintable(label->text()));
        QVERIFY2(whole || label->toolTip().contains(label->text()), qPrintable(label->text()));
        dotted += !whole;
    }
    QCOMPARE(dotted, 2);
    QVERIFY(test::named<QLabel>(window, "Accuracy of the image").width() > 200);
}

void TestWindowHabits::aMessageTakesTwoLinesAndTheRestWhenAsked() {
    MainWindow window;
    window.resize(1366, 768);
    activate(window);
    MessageBar& message = window.message();
    message.showNotice("one line");
    QCoreApplication::processEvents();
    const int least = message.height();
    auto& details = test::named<QToolButton>(message, "All of the message");
    QVERIFY(!details.isVisible());
    QStringList reasons;
    for (int i = 0; i < 117; ++i)
        reasons << QString("file %1 cannot be read, since its pixels are compressed in an unknown way").arg(i);
    message.showNotice(reasons.join('\n'));
    QCoreApplication::processEvents();
    const int line = message.fontMetrics().lineSpacing();
    QVERIFY2(message.height() <= least + 2 * line, qPrintable(QString::number(message.height())));
    QVERIFY(details.isVisible());
    details.click();
    QCoreApplication::processEvents();
    QVERIFY(message.height() > 8 * line && message.height() < window.viewport().height() / 2);
    QVERIFY(window.viewport().rect().contains(message.geometry()));
    QCOMPARE(message.text(), reasons.join('\n'));
    message.showNotice("one line");
    QCoreApplication::processEvents();
    QCOMPARE(message.height(), least);
}

void TestWindowHabits::theRightButtonOffersWhatOneDoesMost() {
    MainWindow window;
    activate(window);
    QTest::mouseClick(&window.viewport(), Qt::RightButton, {}, {100, 100});
    const auto* menu = window.findChild<QMenu*>("imageMenu");
    QVERIFY(menu && menu->isVisible());
    for (const char* name : {"firstView", "pause", "denoised", "copy", "save", "alone", "fitImage"})
        QVERIFY2(menu->actions().contains(window.findChild<QAction*>(name)), name);
}

void TestWindowHabits::keysOfOtherProgramsWorkHere() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    const WindowActions& actions = window.menuActions();
    for (QAction* action : {actions.redo, actions.firstView})
        action->setEnabled(true);
    QSignalSpy redo(actions.redo, &QAction::triggered), reset(actions.firstView, &QAction::triggered);
    QTest::keyClick(&window, Qt::Key_Y, Qt::ControlModifier);
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(redo.count(), 2);
    window.viewport().setCamera(Camera{});
    QTest::keyClick(&window.viewport(), Qt::Key_Home);
    QCOMPARE(reset.count(), 1);
    window.accuracyStatus().strip().setFocus();
    QTest::keyClick(&window.accuracyStatus().strip(), Qt::Key_Home);  // its own
    QCOMPARE(reset.count(), 1);
    window.viewport().setFocus();
    QTest::keyClick(&window, Qt::Key_F1);
    QVERIFY(window.findChild<ManualWindow*>()->isVisible());
}

void TestWindowHabits::moreThanOneFolderIsSaid() {
    MainWindow window;
    const QTemporaryDir first, second;
    QSignalSpy chosen(&window, &MainWindow::folderChosen), others(&window, &MainWindow::othersLeftOut);
    const auto drop = [&](const QStringList& paths) {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& path : paths)
            urls << QUrl::fromLocalFile(path);
        data.setUrls(urls);
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &enter);
        QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &event);
    };
    drop({first.path()});
    QCOMPARE(others.count(), 0);
    drop({first.path(), second.path()});
    QCOMPARE(others.count(), 1);
    QCOMPARE(chosen.last()[0].toString(), first.path());
    for (const QString& name : {first.filePath("a"), first.filePath("b")})
        QVERIFY(QFile(name).open(QFile::WriteOnly));
    drop({first.filePath("a"), first.filePath("b")});  // of one folder
    QCOMPARE(others.count(), 1);
    for (const QString& name : {first.filePath("all.ZIP"), first.filePath("head.nii.gz")}) {  // a scan by itself
        QVERIFY(QFile(name).open(QFile::WriteOnly));
        drop({name});
        QCOMPARE(chosen.last()[0].toString(), name);
    }
    window.message().showNotice("a table is hidden");
    window.message().offer("Show", [] {});
    window.message().add("only one is opened");
    QCOMPARE(window.message().text(), "a table is hidden\nonly one is opened");
    QVERIFY(!window.message().findChild<QPushButton*>()->isHidden());
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestWindowHabits)
#include "window_habits_test.moc"
