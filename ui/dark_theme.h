#pragma once
/// The window's colours: dark and quiet, so that the picture is the brightest thing on the screen.

#include <QApplication>

namespace pdr::ui {

void applyDarkTheme(QApplication& application);

}  // namespace pdr::ui
