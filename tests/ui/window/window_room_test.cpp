/// The division of the window: the image gets most of it, panels what is left.

#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include "tests/support/desktop/the.h"
#include "tests/support/desktop/whole_window.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/accuracy/effect_costs.h"
#include "ui/looks/look_panel.h"
#include "ui/nodes/nodes_panel.h"
#include "ui/rendering/render_panel.h"
#include "ui/series/series_panel.h"
#include "ui/window/main_window.h"

namespace pdr::ui {

class TestWindowRoom : public QObject {
    Q_OBJECT

  private slots:
    void oneOfThePanelsBelowMakesRoomForTheOther();
    void theAccuracyFloatsOverTheImage();
    void noPanelIsSqueezed_data();
    void noPanelIsSqueezed();
    void anEditorLeavesTheImageMostOfTheWindow_data();
    void anEditorLeavesTheImageMostOfTheWindow();
    void editorsGiveWayToEachOther();
    void theImageIsTheLargestThing_data();
    void theImageIsTheLargestThing();
    void whatGaveWayComesBackWithTheRoom();
    void whatIsOpenedByHandStays();
};

static void activate(MainWindow& window) {
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    window.viewport().setFocus();
}

void TestWindowRoom::oneOfThePanelsBelowMakesRoomForTheOther() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    const auto shown = [&] {
        return std::pair(test::the<NodesPanel>(window).isVisible(), test::the<EffectCosts>(window).isVisible());
    };
    window.resize(1200, 800);
    QTest::keyClick(&window, Qt::Key_F12);
    QCOMPARE(shown(), std::pair(true, false));
    QTest::keyClick(&window, Qt::Key_F6);
    QCOMPARE(shown(), std::pair(false, true));
    window.resize(1800, 800);
    QTest::keyClick(&window, Qt::Key_F12);
    QCOMPARE(shown(), std::pair(true, true));
}

/// The panel takes no room from the image, and covers nothing in its corners.
void TestWindowRoom::theAccuracyFloatsOverTheImage() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    window.resize(1366, 768);
    activate(window);
    const QSize before = window.viewport().size();
    QTest::keyClick(&window, Qt::Key_E, Qt::ShiftModifier);
    QVERIFY(test::the<AccuracyPanel>(window).isVisible());
    window.message().showNotice("a message");
    QCoreApplication::processEvents();
    QCOMPARE(window.viewport().size(), before);
    const QWidget* panel = test::the<AccuracyPanel>(window).parentWidget();
    QVERIFY(window.viewport().rect().contains(panel->geometry()));
    QVERIFY(panel->x() > 30 && panel->geometry().right() < before.width() - 30);
    QVERIFY(panel->geometry().bottom() < before.height() - 90);
    QVERIFY(window.viewport().rect().contains(window.message().geometry()));
    QVERIFY(!window.message().geometry().intersects(panel->geometry()));
}

void TestWindowRoom::noPanelIsSqueezed_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("1480 x 920") << QSize(1480, 920);
    QTest::newRow("1366 x 768") << QSize(1366, 768);
}

/// Buttons keep the height that their words need, whatever else is open, and the looks stay.
void TestWindowRoom::noPanelIsSqueezed() {
    QFETCH(QSize, size);
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    window.accuracyStatus().setRemarks({"a remark"});
    window.resize(size);
    for (const int key : {int(Qt::Key_F8), int(Qt::Key_F12), int(Qt::Key_F5), int(Qt::Key_F7), int(Qt::Key_F9)}) {
        QTest::keyClick(&window, Qt::Key(key));
        QCoreApplication::processEvents();
        QVERIFY(test::the<LookPanel>(window).isVisible());
        for (const QPushButton* button : test::the<LookPanel>(window).findChildren<QPushButton*>())
            QVERIFY2(button->height() >= button->minimumSizeHint().height(), qPrintable(button->text()));
        QVERIFY(test::the<LookPanel>(window).gallery().parentWidget()->height() >= LookGallery::kImage);
    }
}

void TestWindowRoom::anEditorLeavesTheImageMostOfTheWindow_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("key");
    QTest::addColumn<QSize>("size");
    const auto editors = {std::pair("Tissue", Qt::Key_F5), std::pair("Light", Qt::Key_F8),
                          std::pair("Camera", Qt::Key_F7), std::pair("Cut", Qt::Key_F9)};
    for (const auto& [name, key] : editors)
        for (const QSize size : {QSize(1100, 700), QSize(1400, 900), QSize(2000, 1000), QSize(3000, 2000)})
            QTest::addRow("%s, %d x %d", name, size.width(), size.height()) << QString(name) << int(key) << size;
}

/// The image keeps 60 %; panels that gave way come back in whichever way the editor is closed.
void TestWindowRoom::anEditorLeavesTheImageMostOfTheWindow() {
    QFETCH(QString, name);
    QFETCH(int, key);
    QFETCH(QSize, size);
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    window.accuracyStatus().setRemarks({"a remark"});
    window.resize(size);
    QCoreApplication::processEvents();
    const auto shown = [&] {
        return std::pair(test::the<SeriesPanel>(window).isVisible(), test::the<RenderPanel>(window).isVisible());
    };
    const auto before = shown();
    const auto image = [&] { return double(window.viewport().width()) * window.viewport().height(); };
    const auto editor = [&] { return window.findChild<QDockWidget*>(name)->isVisible(); };
    QTest::keyClick(&window, Qt::Key(key));
    QTRY_VERIFY(editor());
    QTRY_VERIFY2(image() >= 0.6 * size.width() * size.height(),
                 qPrintable(QString::number(image() / (size.width() * size.height()))));
    QVERIFY(test::the<LookPanel>(window).isVisible() || size.height() < 900);  // there is no room for both
    for (QToolButton* fold : window.findChildren<QToolButton*>())
        if (fold->accessibleName() == QString("Close %1").arg(name))
            fold->click();
    QVERIFY(!editor());
    QCOMPARE(shown(), before);
}

/// The right-hand column has one editor at a time.
void TestWindowRoom::editorsGiveWayToEachOther() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    const auto shown = [&] {
        QString names;
        for (const char* name : {"Tissue", "Light", "Camera"})
            if (window.findChild<QDockWidget*>(name)->isVisible())
                names += name;
        return names;
    };
    QCOMPARE(shown(), QString());
    window.resize(1600, 1000);
    QTest::keyClick(&window, Qt::Key_F4);
    QVERIFY(test::the<RenderPanel>(window).isVisible());
    for (const auto& [key, name] : {std::pair(Qt::Key_F5, "Tissue"), std::pair(Qt::Key_F7, "Camera"),
                                    std::pair(Qt::Key_F8, "Light"), std::pair(Qt::Key_F8, "")}) {
        QTest::keyClick(&window, key);
        QTRY_COMPARE(shown(), QString(name));
    }
    QVERIFY(test::the<RenderPanel>(window).isVisible());  // what gave way to the first
}

void TestWindowRoom::theImageIsTheLargestThing_data() {
    QTest::addColumn<QSize>("size");
    QTest::addColumn<double>("share");
    QTest::newRow("800 x 600") << QSize(800, 600) << 0.5;
    QTest::newRow("1100 x 700") << QSize(1100, 700) << 0.6;
    QTest::newRow("1400 x 900") << QSize(1400, 900) << 0.6;
}

/// The image is the largest with any one panel open on the right.
void TestWindowRoom::theImageIsTheLargestThing() {
    QFETCH(QSize, size);
    QFETCH(double, share);
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    window.accuracyStatus().setRemarks({"a remark"});
    for (const int key : {0, int(Qt::Key_F5), int(Qt::Key_F8), int(Qt::Key_F7), int(Qt::Key_F9), int(Qt::Key_F4)}) {
        window.resize(size);
        if (key != 0)
            QTest::keyClick(&window, Qt::Key(key));
        QCoreApplication::processEvents();
        QCOMPARE(window.size(), size);
        const double has = double(window.viewport().width()) * window.viewport().height();
        const double least = key == 0 ? share : std::min(share, 0.45);
        QVERIFY2(has >= (size.width() >= 1100 ? share : least) * size.width() * size.height(),
                 qPrintable(QString("key %1: %2").arg(key).arg(has / (size.width() * size.height()))));
        for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
            QVERIFY(!dock->isVisible() || double(dock->width()) * dock->height() < has);
        if (key != 0)
            QTest::keyClick(&window, Qt::Key(key));
    }
}

void TestWindowRoom::whatGaveWayComesBackWithTheRoom() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    const auto shown = [&](QSize size) {
        window.resize(size);
        QCoreApplication::processEvents();
        return test::the<SeriesPanel>(window).isVisible();
    };
    QVERIFY(shown({1600, 1000}));
    QVERIFY(!shown({800, 600}));
    const QByteArray kept = window.wantedState();
    QVERIFY(!test::the<SeriesPanel>(window).isVisible());
    QVERIFY(shown({1600, 1000}));
    const test::WholeWindow another;
    MainWindow& other = another.window;
    activate(other);
    other.resize(1600, 1000);
    other.restoreState(kept);
    QVERIFY(test::the<SeriesPanel>(other).isVisible());
}

/// A panel opened by the user stays while the window is resized; one that the user closed stays closed.
void TestWindowRoom::whatIsOpenedByHandStays() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    window.resize(800, 600);
    QCoreApplication::processEvents();
    QVERIFY(!test::the<SeriesPanel>(window).isVisible());
    QTest::keyClick(&window, Qt::Key_F2);
    QVERIFY(test::the<SeriesPanel>(window).isVisible());
    window.resize(820, 600);
    QCoreApplication::processEvents();
    QVERIFY(test::the<SeriesPanel>(window).isVisible());
    QTest::keyClick(&window, Qt::Key_F2);
    window.resize(1600, 1000);
    QCoreApplication::processEvents();
    QVERIFY(!test::the<SeriesPanel>(window).isVisible());
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestWindowRoom)
#include "window_room_test.moc"
