/// The division of the window: the image gets most of it, panels what is left.

#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QToolButton>

#include "tests/support/desktop/named_widget.h"
#include "tests/support/desktop/the.h"
#include "tests/support/desktop/whole_window.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/accuracy/effect_costs.h"
#include "ui/looks/look_panel.h"
#include "ui/nodes/nodes_panel.h"
#include "ui/rendering/render_panel.h"
#include "ui/series/series_panel.h"
#include "ui/text/language.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/line_icon.h"
#include "ui/window/main_window.h"

namespace pdr::ui {

class TestWindowRoom : public QObject {
    Q_OBJECT

  private slots:
    void oneOfThePanelsBelowMakesRoomForTheOther();
    void theAccuracyFloatsOverTheImage();
    void noPanelIsSqueezed_data();
    void noPanelIsSqueezed();
    void noPanelResizesTheImage();
    void theSideBarClosesWithOneKey();
    void tabsSayWhatTheyOpen();
    void anEditorLeavesTheImageMostOfTheWindow_data();
    void anEditorLeavesTheImageMostOfTheWindow();
    void onePanelIsShownAtATime();
    void theImageIsTheLargestThing_data();
    void theImageIsTheLargestThing();
    void whatGaveWayComesBackWithTheRoom();
    void whatIsOpenedByHandStays();
};

/// The keys of the panels in the side bar.
static constexpr QKeyCombination kSideBarKeys[] = {Qt::Key_F4, Qt::Key_F5, Qt::Key_F7,           Qt::Key_F8,
                                                   Qt::Key_F9, Qt::Key_F3, Qt::CTRL | Qt::Key_M, Qt::CTRL | Qt::Key_P};

static void press(MainWindow& window, QKeyCombination key) {
    QTest::keyClick(&window, key.key(), key.keyboardModifiers());
}

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
    QTest::addColumn<QString>("language");
    QTest::addColumn<QSize>("size");
    for (const QString& code : languages())
        for (const QSize size : {QSize(1480, 920), QSize(1366, 768)})
            QTest::addRow("%s, %d x %d", qPrintable(code), size.width(), size.height()) << code << size;
}

/// Returns the texts of a label or a button that have not the room that they need.
static QStringList cutTexts(const QWidget& within) {
    QStringList cut;
    for (const QWidget* widget : within.findChildren<QWidget*>()) {
        const auto* label = qobject_cast<const QLabel*>(widget);
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const QString text = label ? label->text() : button ? button->text() : QString();
        const bool mayBe = text.isEmpty() || qobject_cast<const ElidedLabel*>(widget) || (label && label->wordWrap());
        if (!widget->isVisible() || mayBe)
            continue;
        const QSize needed = widget->minimumSizeHint();
        if (widget->width() < needed.width() || widget->height() < needed.height())
            cut << text;
    }
    return cut;
}

/// Labels and buttons have the room that their words need in each language, and nothing scrolls sideways.
void TestWindowRoom::noPanelIsSqueezed() {
    QFETCH(QString, language);
    QFETCH(QSize, size);
    speak(*qApp, language);
    const auto english = qScopeGuard([] { speak(*qApp, "en"); });
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    window.accuracyStatus().setRemarks({"a remark"});
    window.resize(size);
    QTest::keyClick(&window, Qt::Key_F12);
    for (const QKeyCombination key : kSideBarKeys) {
        press(window, key);
        QCoreApplication::processEvents();
        const auto& sideBar = test::the<SideBar>(window);
        QCOMPARE(sideBar.width(), SideBar::kWidth);
        QCOMPARE(cutTexts(sideBar).join("; "), QString());
        for (const QScrollArea* area : sideBar.findChildren<QScrollArea*>())
            QVERIFY2(!area->isVisible() || area->horizontalScrollBar()->maximum() == 0,
                     qPrintable(QString::number(key.toCombined())));
    }
}

void TestWindowRoom::noPanelResizesTheImage() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    window.resize(1366, 768);
    activate(window);
    QCoreApplication::processEvents();
    const QSize before = window.viewport().size();
    for (int i = 0; i < 3; ++i)
        for (const QKeyCombination key : kSideBarKeys) {
            press(window, key);
            QCoreApplication::processEvents();
            QCOMPARE(window.viewport().size(), before);
        }
}

void TestWindowRoom::theSideBarClosesWithOneKey() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    const auto& sideBar = test::the<SideBar>(window);
    QTest::keyClick(&window, Qt::Key_F5);
    QTest::keyClick(&window, Qt::Key_F10);
    QVERIFY(!sideBar.isVisible() && !window.panelToggle("Tissue")->isChecked());
    QTest::keyClick(&window, Qt::Key_F10);
    QVERIFY(sideBar.isVisible() && window.panelToggle("Tissue")->isChecked());
    QTest::keyClick(&window, Qt::Key_F10);
    QTest::keyClick(&window, Qt::Key_F8);  // the key of a panel opens the side bar, too
    QVERIFY(sideBar.isVisible() && window.panelToggle("Light")->isChecked());
    QTest::keyClick(&window, Qt::Key_F3);
    QTest::keyClick(&window, Qt::Key_F3);  // of the first panel: there is none to go back to
    QVERIFY(!sideBar.isVisible());
}

void TestWindowRoom::tabsSayWhatTheyOpen() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    for (const char* name : {"Look", "Tissue", "Light", "Camera", "Cut", "Measurements", "Rendering"}) {
        QAction* toggle = window.panelToggle(name);
        auto& tab = test::named<QToolButton>(window, toggle->text());
        QVERIFY2(hasLineIcon(toggle->objectName()), name);
        QCOMPARE(tab.toolTip(), QString("%1 (%2)").arg(toggle->text(), toggle->shortcut().toString()));
        tab.click();
        QVERIFY(toggle->isChecked() && tab.isChecked());
        tab.click();
        QVERIFY(toggle->isChecked() && tab.isChecked());
    }
    window.panelToggle("Light")->setShortcut(Qt::Key_Z);
    QCOMPARE(test::named<QToolButton>(window, "Light").toolTip(), QString("Light (Z)"));
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
    const auto editor = [&] { return window.panelToggle(name)->isChecked(); };
    QTest::keyClick(&window, Qt::Key(key));
    QTRY_VERIFY(editor());
    QTRY_VERIFY2(image() >= 0.6 * size.width() * size.height(),
                 qPrintable(QString::number(image() / (size.width() * size.height()))));
    QVERIFY(!test::the<LookPanel>(window).isVisible());
    for (QToolButton* fold : window.findChildren<QToolButton*>())
        if (fold->accessibleName() == QString("Close %1").arg(name))
            fold->click();
    QVERIFY(!editor());
    QCOMPARE(shown(), before);
}

/// A panel's own key goes back to the looks.
void TestWindowRoom::onePanelIsShownAtATime() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    const auto shown = [&] {
        QStringList names;
        for (const char* name : {"Look", "Tissue", "Light", "Camera", "Cut", "Measurements", "Rendering"})
            if (window.panelToggle(name)->isChecked())
                names << name;
        return names;
    };
    QCOMPARE(shown(), QStringList{"Look"});
    window.resize(1600, 1000);
    for (const auto& [key, name] : {std::pair(Qt::Key_F4, "Rendering"), std::pair(Qt::Key_F5, "Tissue"),
                                    std::pair(Qt::Key_F8, "Light"), std::pair(Qt::Key_F8, "Look")}) {
        QTest::keyClick(&window, key);
        QCOMPARE(shown(), QStringList{name});
        QCOMPARE(test::the<RenderPanel>(window).isVisible(), name == QString("Rendering"));
    }
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
    QVERIFY(shown({1920, 1080}));
    QVERIFY(!shown({800, 600}));
    const QByteArray kept = window.wantedState();
    QVERIFY(!test::the<SeriesPanel>(window).isVisible());
    QVERIFY(shown({1920, 1080}));
    const test::WholeWindow another;
    MainWindow& other = another.window;
    activate(other);
    other.resize(1920, 1080);
    other.restorePanels(kept);
    QVERIFY(test::the<SeriesPanel>(other).isVisible());
    QTest::keyClick(&other, Qt::Key_F2);
    const QByteArray closed = other.wantedState();
    for (const QByteArray& state : {other.saveState(), QByteArray("nonsense"), QByteArray(), kept.left(40)})
        other.restorePanels(state);  // from another version, or damaged
    QVERIFY(test::the<LookPanel>(other).isVisible());
    QCOMPARE(other.wantedState(), closed);
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
    window.resize(1920, 1080);
    QCoreApplication::processEvents();
    QVERIFY(!test::the<SeriesPanel>(window).isVisible());
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestWindowRoom)
#include "window_room_test.moc"
