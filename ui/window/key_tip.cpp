#include "ui/window/key_tip.h"

namespace pdr::ui {

QString keyTip(const QString& text, const QAction& action) {
    const QString key = action.shortcut().toString(QKeySequence::NativeText);
    return key.isEmpty() ? text : QString("%1 (%2)").arg(text, key);
}

}  // namespace pdr::ui
