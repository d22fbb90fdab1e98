/// The tool bar: what its buttons are and say, that one sees them, and when it gives way.

#include <QMenuBar>
#include <QPainter>
#include <QStatusBar>
#include <QTest>

#include "tests/support/desktop/contrast.h"
#include "tests/support/desktop/the.h"
#include "tests/support/desktop/whole_window.h"
#include "ui/widgets/line_icon.h"
#include "ui/window/action_button.h"
#include "ui/window/main_window.h"

namespace pdr::ui {

class TestToolBar : public QObject {
    Q_OBJECT

  private slots:
    void tenActionsHaveAButton();
    void aButtonFollowsItsAction();
    void iconsAreSeen_data();
    void iconsAreSeen();
    void pausedLooksAnother();
    void itIsHiddenForGood();
    void itGivesWayToTheImage();
};

static QList<ActionButton*> buttonsOf(const MainWindow& window) {
    QList<ActionButton*> buttons;
    for (QToolButton* button : test::the<ToolBar>(window).findChildren<QToolButton*>())
        if (auto* one = dynamic_cast<ActionButton*>(button))
            buttons << one;
    return buttons;
}

/// The actions are those of the menus, so that nothing is connected twice.
void TestToolBar::tenActionsHaveAButton() {
    const test::WholeWindow whole;
    const QList<ActionButton*> buttons = buttonsOf(whole.window);
    QCOMPARE(buttons.size(), 10);
    QStringList names;
    for (const ActionButton* button : buttons) {
        const QAction& action = *button->defaultAction();
        names << action.objectName();
        QVERIFY2(hasLineIcon(action.objectName()), qPrintable(action.objectName()));
        QVERIFY(whole.window.findChildren<QAction*>(action.objectName()) == QList<QAction*>{button->defaultAction()});
        QVERIFY(!button->accessibleName().isEmpty() && !button->accessibleName().contains('&'));
        const QString key = action.shortcut().toString(QKeySequence::NativeText);
        QVERIFY2(!key.isEmpty() && button->toolTip().endsWith("(" + key + ")"), qPrintable(button->toolTip()));
        QVERIFY(button->focusPolicy() == Qt::NoFocus);
    }
    QCOMPARE(names.removeDuplicates(), 0);
}

void TestToolBar::aButtonFollowsItsAction() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    window.resize(1400, 800);
    window.show();
    ActionButton* looks = nullptr;
    for (ActionButton* button : buttonsOf(window))
        if (button->defaultAction() == window.panelToggle("Look"))
            looks = button;
    QVERIFY(looks && looks->isChecked() && looks->isVisible());
    window.panelToggle("Light")->trigger();
    QVERIFY(!looks->isChecked());
    QTest::mouseClick(looks, Qt::LeftButton);
    QVERIFY(window.panelToggle("Look")->isChecked() && looks->isChecked());
    window.setKeys({{"LookPanel", "Ctrl+J"}});
    QVERIFY2(looks->toolTip().endsWith("(Ctrl+J)"), qPrintable(looks->toolTip()));
    QVERIFY(!looks->icon().isNull() && looks->accessibleName() == "Appearance");
}

void TestToolBar::iconsAreSeen_data() {
    QTest::addColumn<ThemeChoice>("theme");
    QTest::addColumn<int>("size");
    for (const int size : {16, 20, 32}) {
        QTest::addRow("dark, %d", size) << ThemeChoice::dark << size;
        QTest::addRow("light, %d", size) << ThemeChoice::light << size;
    }
}

/// The lines of each icon stand out from the window and from a checked button, and no two icons are the same.
void TestToolBar::iconsAreSeen() {
    QFETCH(ThemeChoice, theme);
    QFETCH(int, size);
    applyTheme(*qApp, theme);
    const Theme& colours = theme == ThemeChoice::dark ? darkTheme() : lightTheme();
    const test::WholeWindow whole;
    QList<QImage> seen;
    for (const ActionButton* button : buttonsOf(whole.window))
        for (const QColor& ground : {colours.window, colours.accent}) {
            QImage image(size, size, QImage::Format_RGB32);
            image.fill(ground);
            QPainter painter(&image);
            button->icon().paint(&painter, image.rect());
            painter.end();
            int clear = 0;
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x)
                    clear += test::contrast(image.pixelColor(x, y), ground) >= 3;
            QVERIFY2(clear >= size * size / 20, qPrintable(button->accessibleName() + QString::number(clear)));
            QVERIFY2(!seen.contains(image), qPrintable(button->accessibleName()));
            seen << image;
        }
    applyTheme(*qApp, ThemeChoice::dark);
}

void TestToolBar::pausedLooksAnother() {
    const QIcon icon = lineIcon("pause");
    const auto shown = [&](QIcon::State state) { return icon.pixmap({32, 32}, QIcon::Normal, state).toImage(); };
    QVERIFY(shown(QIcon::On) != shown(QIcon::Off));
    QVERIFY(icon.pixmap({32, 32}, QIcon::Disabled).toImage() != shown(QIcon::Off));
}

void TestToolBar::itIsHiddenForGood() {
    const test::WholeWindow whole, another;
    for (const test::WholeWindow* one : {&whole, &another}) {
        one->window.resize(1400, 800);
        one->window.show();
    }
    QVERIFY(test::the<ToolBar>(whole.window).isVisible());
    whole.window.findChild<QAction*>("toolBarShown")->trigger();
    QVERIFY(!test::the<ToolBar>(whole.window).isVisible());
    another.window.restorePanels(whole.window.wantedState());
    QVERIFY(!test::the<ToolBar>(another.window).isVisible());
    another.window.resize(1500, 800);
    QVERIFY(!test::the<ToolBar>(another.window).isVisible());
}

/// In small windows the image needs the width; who shows the tool bar nevertheless keeps it.
void TestToolBar::itGivesWayToTheImage() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    window.show();
    const auto shown = [&](QSize size) {
        window.resize(size);
        QCoreApplication::processEvents();
        return test::the<ToolBar>(window).isVisible();
    };
    QVERIFY(shown({1366, 768}));
    const double image = double(window.viewport().width()) * window.viewport().height();
    QVERIFY2(image >= 0.6 * 1366 * 768, qPrintable(QString::number(image / (1366 * 768))));
    QVERIFY(window.viewport().height() + window.menuBar()->height() + window.statusBar()->height() == 768);
    QVERIFY(!shown({900, 640}));
    QVERIFY(shown({1366, 768}));
    QVERIFY(!shown({900, 640}));
    window.findChild<QAction*>("toolBarShown")->trigger();
    QVERIFY(test::the<ToolBar>(window).isVisible() && shown({880, 640}));
    window.menuActions().alone->trigger();
    QVERIFY(!test::the<ToolBar>(window).isVisible());
    window.menuActions().alone->trigger();
    QVERIFY(test::the<ToolBar>(window).isVisible());
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestToolBar)
#include "tool_bar_test.moc"
