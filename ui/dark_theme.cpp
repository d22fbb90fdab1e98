#include "ui/dark_theme.h"

#include <QPalette>
#include <QStyleFactory>

namespace pdr::ui {

void applyDarkTheme(QApplication& application) {
    const QColor ground(34, 35, 38), panel(43, 44, 48), raised(58, 60, 65), text(222, 222, 218), faint(140, 142, 146);
    const QColor accent(74, 118, 168);

    QPalette palette;
    palette.setColor(QPalette::Window, panel);
    palette.setColor(QPalette::WindowText, text);
    palette.setColor(QPalette::Base, ground);
    palette.setColor(QPalette::AlternateBase, panel);
    palette.setColor(QPalette::Text, text);
    palette.setColor(QPalette::PlaceholderText, faint);
    palette.setColor(QPalette::Button, raised);
    palette.setColor(QPalette::ButtonText, text);
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::ToolTipBase, raised);
    palette.setColor(QPalette::ToolTipText, text);
    palette.setColor(QPalette::Highlight, accent);
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, QColor(120, 170, 230));
    palette.setColor(QPalette::Light, panel);  // the shadow of disabled text
    palette.setColor(QPalette::Mid, QColor(70, 72, 77));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, QColor(118, 120, 124));

    application.setStyle(QStyleFactory::create("Fusion"));
    application.setPalette(palette);
    // What a palette cannot say: a chosen button stands out by its colour and its weight.
    application.setStyleSheet(
        "QPushButton { padding: 6px 12px; border: 1px solid #4b4e54; border-radius: 4px; background: #3a3c41; }"
        "QPushButton:hover { background: #45484e; }"
        "QPushButton:pressed { background: #303236; }"
        "QPushButton:checked { background: #4a76a8; border-color: #6f9ccf; font-weight: bold; color: white; }"
        "QPushButton:focus { border-color: #9cc0ea; }"
        "QMainWindow::separator { width: 1px; height: 1px; background: #232427; }"
        "QStatusBar::item { border: none; }");
}

}  // namespace pdr::ui
