/// The window as a whole: its title, its keys, and what may be dropped on it.

#include <QDragEnterEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/desktop/named_widget.h"
#include "ui/window/main_window.h"
#include "ui/window/program_icon.h"

namespace pdr::ui {

class TestMainWindow : public QObject {
    Q_OBJECT

  private slots:
    void theTitleAlwaysSaysNotForDiagnosticUse();
    void theSixViewsHaveKeys_data();
    void theSixViewsHaveKeys();
    void theFirstViewAndPauseHaveKeys();
    void theRawPictureHasAKey();
    void undoAndRedoHaveKeysAndNeedSomethingToUndo();
    void keysWorkWhenThePictureIsAlone();
    void stepsToUndoAreNamed();
    void coloursAreChosenInTheMenu();
    void theStartOffersWaysToOpen();
    void recentFoldersAreOffered();
    void withoutAVolumeNothingActsOnIt();
    void thePictureSaysWhoAndAloneHowGood();
    void theKeyboardIsSeenOnThePicture();
    void theKeysAreShownAndGoAwayAgain();
    void escapeCancelsAndClosesTheMessage();
    void aDroppedFolderIsOpened();
    void aDroppedFileStandsForItsFolder();
    void aDroppedPictureOfASkyIsNoFolder();
    void settersAreSilent();
    void itHasAnIconWithoutAPluginForSvg();
};

void TestMainWindow::theTitleAlwaysSaysNotForDiagnosticUse() {
    MainWindow window;
    QVERIFY(window.windowTitle().contains("Not for diagnostic use"));
    window.setSubject("Thorax");
    QVERIFY(window.windowTitle().contains("Not for diagnostic use"));
    QVERIFY(window.windowTitle().startsWith("Thorax"));
}

static void activate(MainWindow& window) {
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    window.viewport().setFocus();
}

void TestMainWindow::theSixViewsHaveKeys_data() {
    QTest::addColumn<int>("key");
    QTest::addColumn<int>("view");
    QTest::newRow("front") << int(Qt::Key_1) << int(StandardView::anterior);
    QTest::newRow("back") << int(Qt::Key_2) << int(StandardView::posterior);
    QTest::newRow("left") << int(Qt::Key_3) << int(StandardView::left);
    QTest::newRow("right") << int(Qt::Key_4) << int(StandardView::right);
    QTest::newRow("head") << int(Qt::Key_5) << int(StandardView::superior);
    QTest::newRow("feet") << int(Qt::Key_6) << int(StandardView::inferior);
}

void TestMainWindow::theSixViewsHaveKeys() {
    QFETCH(int, key);
    QFETCH(int, view);
    MainWindow window;
    activate(window);
    QList<int> chosen;
    connect(&window, &MainWindow::viewChosen, &window, [&](StandardView v) { chosen << int(v); });
    QTest::keyClick(&window, Qt::Key(key));
    QTest::keyClick(&window, Qt::Key(key), Qt::KeypadModifier);
    QCOMPARE(chosen, QList<int>({view, view}));
}

void TestMainWindow::theFirstViewAndPauseHaveKeys() {
    MainWindow window;
    activate(window);
    QSignalSpy reset(&window, &MainWindow::resetRequested), pause(&window, &MainWindow::pauseChosen);
    QTest::keyClick(&window.viewport(), Qt::Key_R);
    QTest::keyClick(&window.viewport(), Qt::Key_Space);
    QTest::keyClick(&window.viewport(), Qt::Key_Space);
    QCOMPARE(reset.count(), 1);
    QCOMPARE(pause.count(), 2);
    QCOMPARE(pause[0][0].toBool(), true);
    QCOMPARE(pause[1][0].toBool(), false);
}

void TestMainWindow::theRawPictureHasAKey() {
    MainWindow window;
    activate(window);
    window.setSmoothed(true);
    QSignalSpy chosen(&window, &MainWindow::smoothingChosen);
    QTest::keyClick(&window.viewport(), Qt::Key_S);
    QTest::keyClick(&window.viewport(), Qt::Key_S);
    QCOMPARE(chosen.count(), 2);
    QCOMPARE(chosen[0][0].toBool(), false);
    QCOMPARE(chosen[1][0].toBool(), true);
}

void TestMainWindow::undoAndRedoHaveKeysAndNeedSomethingToUndo() {
    MainWindow window;
    activate(window);
    QSignalSpy undo(&window, &MainWindow::undoRequested), redo(&window, &MainWindow::redoRequested);
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(undo.count(), 0);
    window.setUndoAvailable(true, true);
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(undo.count(), 1);
    QCOMPARE(redo.count(), 1);
}

void TestMainWindow::keysWorkWhenThePictureIsAlone() {
    MainWindow window;
    activate(window);
    QSignalSpy reset(&window, &MainWindow::resetRequested);
    QTest::keyClick(&window, Qt::Key_F11);
    QVERIFY(!window.menuBar()->isVisible());
    QVERIFY(!window.look().isVisible());
    QTest::keyClick(&window, Qt::Key_R);
    QCOMPARE(reset.count(), 1);
    QTest::keyClick(&window, Qt::Key_Escape);
    QVERIFY(window.menuBar()->isVisible());
    QVERIFY(window.look().isVisible());
}

static QAction* actionCalled(MainWindow& window, const QString& text) {
    for (QAction* action : window.findChildren<QAction*>())
        if (action->text().remove('&') == text)
            return action;
    return nullptr;
}

void TestMainWindow::stepsToUndoAreNamed() {
    MainWindow window;
    window.setUndoAvailable(true, true);
    window.setUndoTexts("Undo turning the view", "Redo choosing a look");
    const QAction* undo = actionCalled(window, "Undo turning the view");
    QVERIFY(undo && actionCalled(window, "Redo choosing a look"));
    QCOMPARE(undo->toolTip(), QString("Undo turning the view"));
    QCOMPARE(undo->shortcut(), QKeySequence(QKeySequence::Undo));
}

void TestMainWindow::coloursAreChosenInTheMenu() {
    MainWindow window;
    QSignalSpy chosen(&window, &MainWindow::themeChosen);
    window.setTheme(ThemeChoice::system);
    QVERIFY(actionCalled(window, "As the system")->isChecked() && chosen.isEmpty());
    actionCalled(window, "Dark")->trigger();
    QCOMPARE(chosen.value(0).value(0).value<ThemeChoice>(), ThemeChoice::dark);
    QVERIFY(!actionCalled(window, "As the system")->isChecked());
}

void TestMainWindow::theStartOffersWaysToOpen() {
    MainWindow window;
    activate(window);
    window.resize(800, 600);
    QVERIFY(!test::named<QAbstractButton>(window, "Open a folder").isVisible());
    window.setStartShown(true);
    QCoreApplication::processEvents();
    QVERIFY(test::named<QAbstractButton>(window, "Open a folder").isVisible());
    QVERIFY(!test::named<QAbstractButton>(window, "Open the example").isVisible());
    window.setExample("/example");
    QSignalSpy chosen(&window, &MainWindow::folderChosen);
    test::named<QAbstractButton>(window, "Open the example").click();
    QCOMPARE(chosen.value(0).value(0).toString(), QString("/example"));
}

void TestMainWindow::recentFoldersAreOffered() {
    MainWindow window;
    window.setStartShown(true);
    QSignalSpy chosen(&window, &MainWindow::folderChosen), forget(&window, &MainWindow::forgetFoldersRequested);
    QSignalSpy remember(&window, &MainWindow::rememberFoldersChosen);
    QVERIFY(!actionCalled(window, "Remember folders")->isChecked());
    QVERIFY(!actionCalled(window, "Forget these folders")->isEnabled());
    window.setRecentFolders({"/a/newest", "/a/older"}, true);
    QVERIFY(actionCalled(window, "Remember folders")->isChecked());
    test::named<QAbstractButton>(window, "Open /a/older").click();
    actionCalled(window, "/a/newest")->trigger();
    QCOMPARE(chosen.count(), 2);
    QCOMPARE(chosen[0][0].toString(), QString("/a/older"));
    QCOMPARE(chosen[1][0].toString(), QString("/a/newest"));
    actionCalled(window, "Forget these folders")->trigger();
    actionCalled(window, "Remember folders")->trigger();
    QCOMPARE(forget.count(), 1);
    QCOMPARE(remember.value(0).value(0).toBool(), false);
}

void TestMainWindow::withoutAVolumeNothingActsOnIt() {
    MainWindow window;
    activate(window);
    window.setVolumeAvailable(false);
    QSignalSpy view(&window, &MainWindow::viewChosen), pause(&window, &MainWindow::pauseChosen);
    QTest::keyClick(&window.viewport(), Qt::Key_1);
    QTest::keyClick(&window.viewport(), Qt::Key_Space);
    QVERIFY(view.isEmpty() && pause.isEmpty() && !window.look().isEnabled());
    window.setVolumeAvailable(true);
    QTest::keyClick(&window.viewport(), Qt::Key_1);
    QVERIFY(view.count() == 1 && window.look().isEnabled());
}

/// The texts are in the upper left corner, where nothing else is written.
void TestMainWindow::thePictureSaysWhoAndAloneHowGood() {
    MainWindow window;
    activate(window);
    dicom::ScanResult scan;
    scan.series.resize(1);
    scan.series[0].patient.name = "Family^Given";
    window.series().setScan(scan);
    window.series().setCurrent(0);
    window.status().setText("Good for planning");
    QImage black(640, 480, QImage::Format_RGB32);
    black.fill(Qt::black);
    window.viewport().setPicture({black, Camera{}});
    const auto corner = [&] {
        const QImage all = window.viewport().grab().toImage();
        const QImage part = all.copy(0, 0, all.width() / 3, all.height() / 5);
        int lit = 0;
        for (int y = 0; y < part.height(); ++y)
            for (int x = 0; x < part.width(); ++x)
                lit += qGray(part.pixel(x, y)) > 100;
        return lit;
    };
    QCOMPARE(corner(), 0);
    window.setPatient({"Family, Given", "born 1960-05-17"});
    const int known = corner();
    QVERIFY(known > 50);
    QTest::keyClick(&window, Qt::Key_F11);
    const int named = corner();
    QVERIFY(named > known);
    QTest::keyClick(&window, Qt::Key_N);
    QVERIFY(window.series().patient().contains("hidden") && !window.series().patient().contains("Family"));
    QVERIFY(corner() != named);
    QVERIFY(!window.patient().join(' ').contains("Family") && !window.patient().join(' ').contains("1960"));
    QTest::keyClick(&window, Qt::Key_N);
    QCOMPARE(window.series().patient(), QString("Family, Given"));
}

void TestMainWindow::theKeyboardIsSeenOnThePicture() {
    MainWindow window;
    activate(window);
    QImage black(64, 48, QImage::Format_RGB32);
    black.fill(Qt::black);
    window.viewport().setPicture({black, Camera{}});
    const auto edge = [&] { return window.viewport().grab().toImage().pixelColor(0, 20).lightness(); };
    window.series().setFocus();
    window.viewport().setFocus(Qt::MouseFocusReason);
    QVERIFY(edge() < 50);
    window.look().findChild<QAbstractButton*>()->setFocus();
    window.viewport().setFocus(Qt::TabFocusReason);
    QVERIFY(edge() > 200);
}

void TestMainWindow::theKeysAreShownAndGoAwayAgain() {
    MainWindow window;
    activate(window);
    auto* keys = window.findChild<KeysOverlay*>();
    QVERIFY(!keys->isVisible());
    QTest::keyClick(&window, Qt::Key_H);
    QVERIFY(keys->isVisible());
    QTest::keyClick(&window, Qt::Key_H);
    QVERIFY(!keys->isVisible());
    QTest::keyClick(&window, Qt::Key_Question);
    QVERIFY(keys->isVisible());
    QTest::mouseClick(keys, Qt::LeftButton);
    QVERIFY(!keys->isVisible());
}

void TestMainWindow::escapeCancelsAndClosesTheMessage() {
    MainWindow window;
    activate(window);
    window.message().showError({"something failed", "", ""});
    QSignalSpy cancel(&window, &MainWindow::cancelRequested);
    QTest::keyClick(&window, Qt::Key_Escape);
    QCOMPARE(cancel.count(), 1);
    QVERIFY(window.message().isHidden());
}

static QString droppedOn(MainWindow& window, const QString& path) {
    QSignalSpy chosen(&window, &MainWindow::folderChosen);
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &enter);
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &drop);
    return chosen.value(0).value(0).toString();
}

void TestMainWindow::aDroppedFolderIsOpened() {
    MainWindow window;
    const QTemporaryDir folder;
    QCOMPARE(droppedOn(window, folder.path()), folder.path());
}

void TestMainWindow::aDroppedFileStandsForItsFolder() {
    MainWindow window;
    const QTemporaryDir folder;
    QFile file(folder.filePath("slice"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(droppedOn(window, file.fileName()), folder.path());
}

void TestMainWindow::aDroppedPictureOfASkyIsNoFolder() {
    MainWindow window;
    QSignalSpy sky(&window, &MainWindow::skyDropped);
    const QTemporaryDir folder;
    QFile file(folder.filePath("room.EXR"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(droppedOn(window, file.fileName()).isEmpty());
    QCOMPARE(sky.value(0).value(0).toString(), file.fileName());
    QVERIFY(QDir(folder.path()).mkdir("series.exr"));
    QCOMPARE(droppedOn(window, folder.filePath("series.exr")), folder.filePath("series.exr"));
    QCOMPARE(sky.count(), 1);
}

void TestMainWindow::itHasAnIconWithoutAPluginForSvg() {
    const MainWindow window;
    for (const int size : kIconSizes) {
        const QImage image = window.windowIcon().pixmap(size).toImage();
        QCOMPARE(image.size(), QSize(size, size));
        QVERIFY(window.windowIcon().availableSizes().contains(QSize(size, size)));
        QVERIFY(image.pixelColor(0, 0).alpha() < 32);                     // round corners
        QVERIFY(image.pixelColor(size / 2, size / 4).lightness() > 150);  // bone
    }
}

void TestMainWindow::settersAreSilent() {
    MainWindow window;
    QSignalSpy pause(&window, &MainWindow::pauseChosen), undo(&window, &MainWindow::undoRequested);
    QSignalSpy folder(&window, &MainWindow::folderChosen);
    window.setPaused(true);
    window.setPaused(false);
    window.setUndoAvailable(true, true);
    window.setSubject("x");
    window.setLastFolder("/");
    window.setPictureAvailable(true);
    QCOMPARE(pause.count() + undo.count() + folder.count(), 0);
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestMainWindow)
#include "main_window_test.moc"
