#pragma once
/// Tool tips that end with the key of what they describe.

#include <QAction>

namespace pdr::ui {

/// Returns `text` with the action's key behind it, "Tissue (F5)"; without one if the action has no key.
QString keyTip(const QString& text, const QAction& action);

}  // namespace pdr::ui
