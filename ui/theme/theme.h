#pragma once
/// The window's colours, light and dark. The picture itself has a black ground in both.

#include <QApplication>
#include <QColor>
#include <QPalette>

namespace pdr::ui {

/// Colours by what they are for. Text has a contrast of 4.5 or more to what it stands on, frames and lines one of 3.
struct Theme {
    QColor window;      ///< ground of panels
    QColor base;        ///< ground of lists, plots and what is typed into
    QColor raised;      ///< buttons
    QColor hovered;     ///< buttons under the mouse
    QColor pressed;     ///< buttons held down
    QColor text;        ///< on all of these
    QColor quiet;       ///< headings and remarks, on window and base
    QColor disabled;    ///< text of what cannot be used now
    QColor border;      ///< of everything that can be used
    QColor faint;       ///< lines that only lead the eye
    QColor accent;      ///< ground of what is chosen
    QColor onAccent;    ///< text there
    QColor accentEdge;  ///< its border
    QColor focus;       ///< about what has the keyboard
    QColor line;        ///< data in plots, what has been done
    QColor warning;     ///< ground of messages about what went wrong
    QColor onWarning;   ///< text there
    QColor notice;      ///< ground of messages that only inform
    QColor onNotice;    ///< text there
};

enum class ThemeChoice { dark, light, system };

const Theme& darkTheme();
const Theme& lightTheme();
QPalette paletteOf(const Theme& theme);
/// What a palette cannot say.
QString styleSheetOf(const Theme& theme);

/// Gives the program's windows, open ones as well, these colours. `system`: light or dark as other programs here.
void applyTheme(QApplication& application, ThemeChoice choice);

}  // namespace pdr::ui
