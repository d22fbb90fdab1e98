#pragma once
/// A wheel that passes over a number does not change it.

#include <QWidget>

namespace pdr::ui {

/// Sliders, number fields and lists to choose from in `window` take the wheel only where they have the keyboard; else
/// it scrolls what they lie in.
void guardWheels(QWidget& window);

}  // namespace pdr::ui
