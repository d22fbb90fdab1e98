#include "ui/keys/key_bindings.h"

#include <QCoreApplication>
#include <algorithm>

namespace pdr::ui {
namespace {

struct KeyText {
    Q_DECLARE_TR_FUNCTIONS(KeyBindings)
};

/// Returns whether the image or every control uses the key itself.
bool reserved(const QKeySequence& key) {
    static const QList<QKeySequence> keys{Qt::Key_Left,  Qt::Key_Right, Qt::Key_Up,     Qt::Key_Down, Qt::Key_Plus,
                                          Qt::Key_Minus, Qt::Key_Equal, Qt::Key_Escape, Qt::Key_Tab,  Qt::Key_Return};
    return keys.contains(key);
}

}  // namespace

QString plainText(const QAction& action) {
    return action.text().remove("...").remove('&');
}

KeyBindings::KeyBindings(const QList<QAction*>& actions) : actions_(actions) {
    for (QAction* action : actions)
        own_[action] = action->shortcuts();
}

QString KeyBindings::refusal(const QAction* action, const QKeySequence& key) const {
    if (key.isEmpty())
        return {};
    const QString name = key.toString(QKeySequence::NativeText);
    if (reserved(key))
        return KeyText::tr("%1 cannot be given away: it moves the view or the keyboard's place.").arg(name);
    for (const QAction* other : actions_)
        if (other != action && other->shortcuts().contains(key))
            return KeyText::tr("%1 belongs to \"%2\". Give that another key first.").arg(name, plainText(*other));
    return {};
}

void KeyBindings::choose(QAction* action, const QKeySequence& key) {
    action->setShortcuts(key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{key});
}

void KeyBindings::reset(QAction* action) {
    action->setShortcuts(own_[action]);
}

QMap<QString, QString> KeyBindings::choices() const {
    QMap<QString, QString> choices;
    for (QAction* action : actions_)
        if (action->shortcuts() != ownKeys(action))
            choices[action->objectName()] = QKeySequence::listToString(action->shortcuts(), QKeySequence::PortableText);
    return choices;
}

void KeyBindings::restore(const QMap<QString, QString>& choices) {
    for (QAction* action : std::as_const(actions_))
        if (const auto chosen = choices.find(action->objectName()); chosen != choices.end())
            choose(action, {});
    for (QAction* action : std::as_const(actions_)) {
        const auto chosen = choices.find(action->objectName());
        if (chosen == choices.end())
            continue;
        const QKeySequence key(*chosen, QKeySequence::PortableText);
        if (refusal(action, key).isEmpty())
            choose(action, key);
        else
            reset(action);
    }
}

}  // namespace pdr::ui
