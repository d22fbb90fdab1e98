#pragma once
/// The heading of a panel, with the button that closes it.

#include <QAction>
#include <QWidget>

namespace pdr::ui {

/// Returns a faint heading with a button that hides the panel, as `toggle` does.
QWidget* panelTitle(const QString& title, QAction& toggle);

}  // namespace pdr::ui
