#pragma once
/// The window's colours, light and dark. The image itself has a black background in both.

#include <QApplication>
#include <QColor>
#include <QPalette>

namespace pdr::ui {

/// Colours by their use. Text has a contrast of at least 4.5 to its background, frames and lines one of at least 3.
struct Theme {
    QColor window;      ///< background of panels
    QColor base;        ///< background of lists, plots and fields
    QColor raised;      ///< background of buttons
    QColor hovered;     ///< background of buttons under the pointer
    QColor pressed;     ///< background of pressed buttons
    QColor text;        ///< text on all of the above
    QColor quiet;       ///< headings and remarks, on window and base
    QColor disabled;    ///< text of disabled controls
    QColor border;      ///< border of all controls
    QColor faint;       ///< decorative lines
    QColor accent;      ///< background of the selection
    QColor onAccent;    ///< text on accent
    QColor accentEdge;  ///< border of accent
    QColor focus;       ///< frame of the focused control
    QColor line;        ///< data in plots, progress
    QColor warning;     ///< background of error messages
    QColor onWarning;   ///< text on warning
    QColor notice;      ///< background of notices
    QColor onNotice;    ///< text on notice
};

enum class ThemeChoice { dark, light, system };

const Theme& darkTheme();
const Theme& lightTheme();
/// Returns the theme's colours as a palette.
QPalette paletteOf(const Theme& theme);
/// Returns the style sheet for what a palette cannot express.
QString styleSheetOf(const Theme& theme);

/// Applies the colours to all windows, including open ones. `system`: light or dark as the desktop's other programs.
void applyTheme(QApplication& application, ThemeChoice choice);

}  // namespace pdr::ui
