/// Both themes, light and dark: everything is legible and visible in them.

#include <QImage>
#include <QPainter>
#include <QStyleOption>
#include <QTest>

#include "tests/support/desktop/contrast.h"
#include "ui/theme/theme.h"
#include "ui/theme/theme_style.h"

namespace pdr::ui {

class TestTheme : public QObject {
    Q_OBJECT

  private slots:
    void textCanBeRead_data() { themes(); }
    void textCanBeRead();
    void controlsAreSeen_data() { themes(); }
    void controlsAreSeen();
    void thePaletteSaysTheSame_data() { themes(); }
    void thePaletteSaysTheSame();
    void theStyleSheetKnowsAllItsColours_data() { themes(); }
    void theStyleSheetKnowsAllItsColours();
    void theKeyboardIsSeenOnABox_data() { themes(); }
    void theKeyboardIsSeenOnABox();
    void disabledTextStandsAlone();
    void aChoiceHoldsForOpenWindows();

  private:
    static void themes();
};

void TestTheme::themes() {
    QTest::addColumn<const Theme*>("theme");
    QTest::newRow("dark") << &darkTheme();
    QTest::newRow("light") << &lightTheme();
}

struct Pair {
    const char* what;
    QColor ink, ground;
};

static void atLeast(double least, const std::vector<Pair>& pairs) {
    for (const Pair& pair : pairs)
        QVERIFY2(test::contrast(pair.ink, pair.ground) >= least,
                 qPrintable(QString("%1: %2").arg(pair.what).arg(test::contrast(pair.ink, pair.ground))));
}

void TestTheme::textCanBeRead() {
    QFETCH(const Theme*, theme);
    const Theme& t = *theme;
    atLeast(4.5, {{"text on a panel", t.text, t.window},
                  {"text in a list", t.text, t.base},
                  {"text on a button", t.text, t.raised},
                  {"text on a button under the mouse", t.text, t.hovered},
                  {"text on a button held down", t.text, t.pressed},
                  {"headings", t.quiet, t.window},
                  {"remarks in a list", t.quiet, t.base},
                  {"what is chosen", t.onAccent, t.accent},
                  {"warnings", t.onWarning, t.warning},
                  {"notices", t.onNotice, t.notice},
                  {"links", t.line, t.window},
                  {"links in a list", t.line, t.base}});
    atLeast(3, {{"disabled text", t.disabled, t.window},
                {"disabled text in a list", t.disabled, t.base},
                {"text of a disabled button", t.disabled, t.raised}});
}

void TestTheme::controlsAreSeen() {
    QFETCH(const Theme*, theme);
    const Theme& t = *theme;
    atLeast(3, {{"border on a panel", t.border, t.window},
                {"border in a list", t.border, t.base},
                {"border about a button", t.border, t.raised},
                {"border of what is chosen", t.accentEdge, t.window},
                {"keyboard on a panel", t.focus, t.window},
                {"keyboard in a list", t.focus, t.base},
                {"keyboard on a button", t.focus, t.raised},
                {"keyboard on what is chosen", t.focus, t.accent},
                {"keyboard on a message", t.focus, t.notice},
                {"keyboard on a warning", t.focus, t.warning},
                {"data in a plot", t.line, t.base},
                {"data on a panel", t.line, t.window},
                {"what has been done on the strip", t.line, t.faint},
                {"the strip's knob and hatching on its track", t.text, t.faint},
                {"the ring about the knob on what has been done", t.window, t.line},
                {"buttons in a message", t.border, t.raised}});
}

void TestTheme::thePaletteSaysTheSame() {
    QFETCH(const Theme*, theme);
    const QPalette palette = paletteOf(*theme);
    const auto pair = [&](const char* what, QPalette::ColorRole ink, QPalette::ColorRole ground) {
        return Pair{what, palette.color(ink), palette.color(ground)};
    };
    atLeast(4.5, {pair("window", QPalette::WindowText, QPalette::Window), pair("base", QPalette::Text, QPalette::Base),
                  pair("button", QPalette::ButtonText, QPalette::Button),
                  pair("tool tip", QPalette::ToolTipText, QPalette::ToolTipBase),
                  pair("chosen", QPalette::HighlightedText, QPalette::Highlight),
                  pair("quiet", QPalette::PlaceholderText, QPalette::Base),
                  pair("quiet on a panel", QPalette::PlaceholderText, QPalette::Window),
                  pair("alternate", QPalette::Text, QPalette::AlternateBase)});
}

void TestTheme::theStyleSheetKnowsAllItsColours() {
    QFETCH(const Theme*, theme);
    const QString sheet = styleSheetOf(*theme);
    QVERIFY2(!sheet.contains('@'), qPrintable(sheet));
    QVERIFY(sheet.contains(theme->accentEdge.name()));
    QVERIFY(!sheet.contains(theme->accent.name() + "Edge"));
}

void TestTheme::theKeyboardIsSeenOnABox() {
    QFETCH(const Theme*, theme);
    const ThemeStyle style(*theme);
    QImage image(40, 24, QImage::Format_RGB32);
    image.fill(theme->window);
    QPainter painter(&image);
    QStyleOptionFocusRect option;
    option.rect = image.rect();
    style.drawPrimitive(QStyle::PE_FrameFocusRect, &option, &painter, nullptr);
    painter.end();
    QVERIFY(test::contrast(image.pixelColor(20, 0), theme->window) >= 3);
    QVERIFY(test::contrast(image.pixelColor(20, 1), theme->window) >= 3);
}

/// Etched text would look brighter than that of enabled controls.
void TestTheme::disabledTextStandsAlone() {
    applyTheme(*qApp, ThemeChoice::dark);
    QCOMPARE(qApp->style()->styleHint(QStyle::SH_EtchDisabledText), 0);
}

void TestTheme::aChoiceHoldsForOpenWindows() {
    applyTheme(*qApp, ThemeChoice::dark);
    QWidget window;
    window.show();
    QCOMPARE(window.palette().color(QPalette::Window), darkTheme().window);
    applyTheme(*qApp, ThemeChoice::light);
    QCOMPARE(window.palette().color(QPalette::Window), lightTheme().window);
    applyTheme(*qApp, ThemeChoice::system);
    const QColor system = window.palette().color(QPalette::Window);
    QVERIFY(system == darkTheme().window || system == lightTheme().window);
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestTheme)
#include "theme_test.moc"
