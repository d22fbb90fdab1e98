#pragma once
/// Protection of controls against accidental changes by the wheel.

#include <QWidget>

namespace pdr::ui {

/// Makes sliders, number fields and combo boxes in `window` react to the wheel only while they have the keyboard focus;
/// else the wheel scrolls what contains them.
void guardWheels(QWidget& window);

}  // namespace pdr::ui
