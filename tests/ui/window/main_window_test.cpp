/// The window as a whole: its title, its keys, and what may be dropped on it.

#include <QDragEnterEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/desktop/named_widget.h"
#include "tests/support/desktop/the.h"
#include "tests/support/desktop/told_document.h"
#include "tests/support/desktop/whole_window.h"
#include "ui/looks/look_panel.h"
#include "ui/series/series_panel.h"
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
    void theRawImageHasAKey();
    void undoAndRedoHaveKeysAndNeedSomethingToUndo();
    void keysWorkWhenTheImageIsAlone();
    void coloursAreChosenInTheMenu();
    void theStartOffersWaysToOpen();
    void recentFoldersAreOffered();
    void withoutAVolumeNothingActsOnIt();
    void theImageSaysWhoAndAloneHowGood();
    void theKeyboardIsSeenOnTheImage();
    void theKeysAreShownAndGoAwayAgain();
    void escapeCancelsAndClosesTheMessage();
    void aDroppedFolderIsOpened();
    void aDroppedFileStandsForItsFolder();
    void aDroppedImageOfASkyIsNoFolder();
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
    QSignalSpy chosen(window.menuActions().views[std::size_t(view)], &QAction::triggered);
    QTest::keyClick(&window, Qt::Key(key));
    QTest::keyClick(&window, Qt::Key(key), Qt::KeypadModifier);
    QCOMPARE(chosen.count(), 2);
}

void TestMainWindow::theFirstViewAndPauseHaveKeys() {
    MainWindow window;
    activate(window);
    QSignalSpy reset(window.menuActions().firstView, &QAction::triggered);
    QSignalSpy pause(window.menuActions().pause, &QAction::triggered);
    QTest::keyClick(&window.viewport(), Qt::Key_R);
    QTest::keyClick(&window.viewport(), Qt::Key_Space);
    QTest::keyClick(&window.viewport(), Qt::Key_Space);
    QCOMPARE(reset.count(), 1);
    QCOMPARE(pause.count(), 2);
    QCOMPARE(pause[0][0].toBool(), true);
    QCOMPARE(pause[1][0].toBool(), false);
}

void TestMainWindow::theRawImageHasAKey() {
    MainWindow window;
    activate(window);
    window.menuActions().denoised->setChecked(true);
    QSignalSpy chosen(window.menuActions().denoised, &QAction::triggered);
    QTest::keyClick(&window.viewport(), Qt::Key_S);
    QTest::keyClick(&window.viewport(), Qt::Key_S);
    QCOMPARE(chosen.count(), 2);
    QCOMPARE(chosen[0][0].toBool(), false);
    QCOMPARE(chosen[1][0].toBool(), true);
}

void TestMainWindow::undoAndRedoHaveKeysAndNeedSomethingToUndo() {
    MainWindow window;
    activate(window);
    const WindowActions& actions = window.menuActions();
    QSignalSpy undo(actions.undo, &QAction::triggered), redo(actions.redo, &QAction::triggered);
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(undo.count(), 0);
    for (QAction* action : {actions.undo, actions.redo})
        action->setEnabled(true);
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(undo.count(), 1);
    QCOMPARE(redo.count(), 1);
}

void TestMainWindow::keysWorkWhenTheImageIsAlone() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    window.menuActions().firstView->setEnabled(true);
    QSignalSpy reset(window.menuActions().firstView, &QAction::triggered);
    QTest::keyClick(&window, Qt::Key_F11);
    QVERIFY(!window.menuBar()->isVisible());
    QVERIFY(!test::the<LookPanel>(window).isVisible());
    QTest::keyClick(&window, Qt::Key_R);
    QCOMPARE(reset.count(), 1);
    QTest::keyClick(&window, Qt::Key_Escape);
    QVERIFY(window.menuBar()->isVisible());
    QVERIFY(test::the<LookPanel>(window).isVisible());
}

static QAction* actionCalled(MainWindow& window, const QString& text) {
    for (QAction* action : window.findChildren<QAction*>())
        if (action->text().remove('&') == text)
            return action;
    return nullptr;
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
    window.start().show();
    QCoreApplication::processEvents();
    QVERIFY(test::named<QAbstractButton>(window, "Open a folder").isVisible());
    QVERIFY(!test::named<QAbstractButton>(window, "Open the example").isVisible());
    window.start().setExample("/example");
    QSignalSpy chosen(&window, &MainWindow::folderChosen);
    test::named<QAbstractButton>(window, "Open the example").click();
    QCOMPARE(chosen.value(0).value(0).toString(), QString("/example"));
}

void TestMainWindow::recentFoldersAreOffered() {
    MainWindow window;
    window.start().show();
    const RecentMenu* recent = window.menuActions().recent;
    QSignalSpy chosen(&window, &MainWindow::folderChosen), forget(recent, &RecentMenu::forgetRequested);
    QSignalSpy remember(recent, &RecentMenu::rememberChosen);
    QVERIFY(!actionCalled(window, "Remember folders")->isChecked());
    QVERIFY(!actionCalled(window, "Forget these folders")->isEnabled());
    window.setRecentFolders({"/a/newest", "/a/older"}, true);
    QVERIFY(actionCalled(window, "Remember folders")->isChecked());
    test::named<QAbstractButton>(window, "Open /a/older").click();
    actionCalled(window, "/a/newest")->trigger();
    QCOMPARE(chosen.count(), 2);
    QCOMPARE(chosen[0][0].toString(), QString("/a/older"));
    QCOMPARE(chosen[1][0].toString(), QString("/a/newest"));
    window.setRecentFolders({"/" + QString("long").repeated(40), "/b", "/c", "/d", "/e"}, true);
    const auto buttons = window.start().findChildren<QPushButton*>();
    for (const QPushButton* button : buttons)
        QVERIFY2(button->minimumSizeHint().width() < window.start().width() - 40, qPrintable(button->text()));
    actionCalled(window, "Forget these folders")->trigger();
    actionCalled(window, "Remember folders")->trigger();
    QCOMPARE(forget.count(), 1);
    QCOMPARE(remember.value(0).value(0).toBool(), false);
}

void TestMainWindow::withoutAVolumeNothingActsOnIt() {
    test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    QSignalSpy view(window.menuActions().views[0], &QAction::triggered);
    QSignalSpy pause(window.menuActions().pause, &QAction::triggered);
    QTest::keyClick(&window.viewport(), Qt::Key_1);
    QTest::keyClick(&window.viewport(), Qt::Key_Space);
    QVERIFY(view.isEmpty() && pause.isEmpty() && !test::the<LookPanel>(window).isEnabled());
    whole.desktop.document().open(app::cube());
    QTest::keyClick(&window.viewport(), Qt::Key_1);
    QVERIFY(view.count() == 1 && test::the<LookPanel>(window).isEnabled());
}

/// The texts are in the upper left corner, where nothing else is written.
void TestMainWindow::theImageSaysWhoAndAloneHowGood() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    dicom::ScanResult scan;
    scan.series.resize(1);
    scan.series[0].patient.name = "Family^Given";
    test::the<SeriesPanel>(window).setScan(scan);
    test::the<SeriesPanel>(window).setCurrent(0);
    window.status().setText("Good for planning");
    QImage black(640, 480, QImage::Format_RGB32);
    black.fill(Qt::black);
    window.viewport().setImage({black, Camera{}});
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
    window.setPatient({"Family, Given", "born 1960-05-17"}, {"Patient 1 (name hidden)"});
    const int known = corner();
    QVERIFY(known > 50);
    QTest::keyClick(&window, Qt::Key_F11);
    const int named = corner();
    QVERIFY(named > known);
    QTest::keyClick(&window, Qt::Key_N);
    QVERIFY(test::the<SeriesPanel>(window).patient().contains("hidden") &&
            !test::the<SeriesPanel>(window).patient().contains("Family"));
    QVERIFY(corner() != named);
    QVERIFY(!window.patient().join(' ').contains("Family") && !window.patient().join(' ').contains("1960"));
    QTest::keyClick(&window, Qt::Key_N);
    QCOMPARE(test::the<SeriesPanel>(window).patient(), QString("Family, Given"));
}

void TestMainWindow::theKeyboardIsSeenOnTheImage() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    QImage black(64, 48, QImage::Format_RGB32);
    black.fill(Qt::black);
    window.viewport().setImage({black, Camera{}});
    const auto edge = [&] { return window.viewport().grab().toImage().pixelColor(0, 20).lightness(); };
    test::the<SeriesPanel>(window).setFocus();
    window.viewport().setFocus(Qt::MouseFocusReason);
    QVERIFY(edge() < 50);
    test::the<LookPanel>(window).setEnabled(true);
    test::the<LookPanel>(window).findChild<QAbstractButton*>()->setFocus();
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

void TestMainWindow::aDroppedImageOfASkyIsNoFolder() {
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
    QSignalSpy folder(&window, &MainWindow::folderChosen), theme(&window, &MainWindow::themeChosen);
    QSignalSpy language(&window, &MainWindow::languageChosen), keys(&window, &MainWindow::keysChosen);
    window.setSubject("x");
    window.setLastFolder("/");
    window.setTheme(ThemeChoice::light);
    window.setLanguage("de");
    window.setKeys({{"open", "Ctrl+P"}});
    QCOMPARE(folder.count() + theme.count() + language.count() + keys.count(), 0);
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestMainWindow)
#include "main_window_test.moc"
