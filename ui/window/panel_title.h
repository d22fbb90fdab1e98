#pragma once
/// The heading of a panel.

#include <QAction>
#include <QWidget>

namespace pdr::ui {

/// A quiet heading with a button that folds the panel away, as `toggle` does.
QWidget* panelTitle(const QString& title, QAction& toggle);

}  // namespace pdr::ui
