#include "ui/theme/theme.h"

#include "ui/theme/theme_style.h"

namespace pdr::ui {
namespace {

constexpr auto kStyleSheet = R"(
QPushButton { padding: 6px 12px; border: 1px solid @border; border-radius: 4px; background: @raised; color: @text; }
QPushButton:hover { background: @hovered; }
QPushButton:pressed { background: @pressed; }
QPushButton:disabled { color: @disabled; border-color: @faint; }
QPushButton:checked { background: @accent; border-color: @accentEdge; font-weight: bold; color: @onAccent; }
QPushButton:focus { border: 2px solid @focus; padding: 5px 11px; }
QPushButton[narrow="true"] { padding: 6px; }
QPushButton[narrow="true"]:focus { padding: 5px; }
QToolBar { border: none; padding: 2px; spacing: 2px; }
QToolBar QToolButton, QToolButton[tab="true"] { padding: 5px; border: 1px solid transparent; border-radius: 4px; }
QToolBar QToolButton:hover, QToolButton[tab="true"]:hover { background: @hovered; }
QToolBar QToolButton:checked, QToolButton[tab="true"]:checked { background: @accent; border-color: @accentEdge; }
QToolButton[tab="true"]:focus { border: 2px solid @focus; padding: 4px; }
QToolTip { background: @base; color: @text; border: 1px solid @border; }
QMainWindow::separator { width: 1px; height: 1px; background: @faint; }
QStatusBar::item { border: none; }
#start { background: @window; border: 1px solid @border; border-radius: 8px; }
#message { background: @notice; border: 1px solid @border; border-radius: 6px; }
#message QScrollArea, #message QScrollArea > QWidget > QWidget { background: transparent; }
#message QLabel, #message QToolButton { color: @onNotice; }
#message[warning="true"] { background: @warning; }
#message[warning="true"] QLabel, #message[warning="true"] QToolButton { color: @onWarning; }
)";

/// Returns whether programs that choose no colours are dark.
bool systemIsDark(QApplication& application) {
    application.setPalette(QPalette());
    return application.palette().color(QPalette::Window).lightness() < 128;
}

const Theme& themeOf(QApplication& application, ThemeChoice choice) {
    if (choice == ThemeChoice::system)
        return systemIsDark(application) ? darkTheme() : lightTheme();
    return choice == ThemeChoice::light ? lightTheme() : darkTheme();
}

}  // namespace

const Theme& darkTheme() {
    static const Theme theme{.window = "#2b2c30",
                             .base = "#222326",
                             .raised = "#3a3c41",
                             .hovered = "#45484e",
                             .pressed = "#303236",
                             .text = "#dededa",
                             .quiet = "#a6a8ad",
                             .disabled = "#85878c",
                             .border = "#85888f",
                             .faint = "#46484d",
                             .accent = "#37618f",
                             .onAccent = "#ffffff",
                             .accentEdge = "#78aae6",
                             .focus = "#b4d2f5",
                             .line = "#78aae6",
                             .warning = "#5c3428",
                             .onWarning = "#faeee6",
                             .notice = "#2a3f52",
                             .onNotice = "#e6eef6"};
    return theme;
}

const Theme& lightTheme() {
    static const Theme theme{.window = "#f1f1f3",
                             .base = "#ffffff",
                             .raised = "#fbfbfc",
                             .hovered = "#e6e9ee",
                             .pressed = "#d6dae0",
                             .text = "#1d1e20",
                             .quiet = "#5c5f66",
                             .disabled = "#767980",
                             .border = "#7c7f86",
                             .faint = "#cfd2d7",
                             .accent = "#cfe0f3",
                             .onAccent = "#0e2f54",
                             .accentEdge = "#24639f",
                             .focus = "#0b4f9c",
                             .line = "#1f66b5",
                             .warning = "#f7dccd",
                             .onWarning = "#4a1d0c",
                             .notice = "#dbe8f5",
                             .onNotice = "#12304f"};
    return theme;
}

QPalette paletteOf(const Theme& theme) {
    QPalette palette;
    palette.setColor(QPalette::Window, theme.window);
    palette.setColor(QPalette::WindowText, theme.text);
    palette.setColor(QPalette::Base, theme.base);
    palette.setColor(QPalette::AlternateBase, theme.window);
    palette.setColor(QPalette::Text, theme.text);
    palette.setColor(QPalette::PlaceholderText, theme.quiet);
    palette.setColor(QPalette::Button, theme.raised);
    palette.setColor(QPalette::ButtonText, theme.text);
    palette.setColor(QPalette::BrightText, theme.text);
    palette.setColor(QPalette::ToolTipBase, theme.base);
    palette.setColor(QPalette::ToolTipText, theme.text);
    palette.setColor(QPalette::Highlight, theme.accent);
    palette.setColor(QPalette::HighlightedText, theme.onAccent);
    palette.setColor(QPalette::Link, theme.line);
    palette.setColor(QPalette::LinkVisited, theme.line);
    palette.setColor(QPalette::Light, theme.window);
    palette.setColor(QPalette::Midlight, theme.faint);
    palette.setColor(QPalette::Mid, theme.faint);
    palette.setColor(QPalette::Dark, theme.border);
    palette.setColor(QPalette::Shadow, theme.base);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, theme.disabled);
    return palette;
}

QString styleSheetOf(const Theme& theme) {
    const std::pair<const char*, QColor> names[] = {
        {"@window", theme.window},         {"@base", theme.base},        {"@raised", theme.raised},
        {"@hovered", theme.hovered},       {"@pressed", theme.pressed},  {"@text", theme.text},
        {"@disabled", theme.disabled},     {"@border", theme.border},    {"@faint", theme.faint},
        {"@accentEdge", theme.accentEdge}, {"@accent", theme.accent},    {"@onAccent", theme.onAccent},
        {"@focus", theme.focus},           {"@warning", theme.warning},  {"@onWarning", theme.onWarning},
        {"@notice", theme.notice},         {"@onNotice", theme.onNotice}};
    QString sheet = kStyleSheet;
    for (const auto& [name, colour] : names)
        sheet.replace(name, colour.name());
    return sheet;
}

void applyTheme(QApplication& application, ThemeChoice choice) {
    const Theme& theme = themeOf(application, choice);
    application.setStyle(new ThemeStyle(theme));
    application.setPalette(paletteOf(theme));
    application.setStyleSheet(styleSheetOf(theme));
}

}  // namespace pdr::ui
