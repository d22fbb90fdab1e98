#include "ui/window/action_button.h"

#include <QActionEvent>

#include "ui/keys/key_bindings.h"
#include "ui/widgets/line_icon.h"
#include "ui/window/key_tip.h"

namespace pdr::ui {

ActionButton::ActionButton(QAction& action, QWidget* parent) : QToolButton(parent), action_(action) {
    constexpr int kIcon = 20;
    setIconSize({kIcon, kIcon});
    setAutoRaise(true);
    setFocusPolicy(Qt::NoFocus);  // the keyboard stays with the image; menus and keys have the same actions
    setDefaultAction(&action);
    describe();
}

/// Follows the action, and then puts back what the action has no place for.
void ActionButton::actionEvent(QActionEvent* event) {
    QToolButton::actionEvent(event);
    if (event->action() == &action_)
        describe();
}

void ActionButton::describe() {
    const QString name = plainText(action_), tip = action_.toolTip();
    setIcon(lineIcon(action_.objectName()));
    setAccessibleName(name);
    setToolTip(keyTip(tip == name ? name : name + '\n' + tip, action_));
}

}  // namespace pdr::ui
