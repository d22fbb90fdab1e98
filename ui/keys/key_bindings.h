#pragma once
/// Which keys the window's actions have: their own, or what the user chose instead.

#include <QAction>
#include <QList>
#include <QMap>
#include <QString>

namespace pdr::ui {

class KeyBindings {
  public:
    /// Each has an object name, by which choices are kept, and now its own keys.
    explicit KeyBindings(const QList<QAction*>& actions);

    const QList<QAction*>& actions() const { return actions_; }
    const QList<QKeySequence>& ownKeys(QAction* action) const { return own_.find(action).value(); }
    /// Why `action` cannot have that key, naming what has it; empty: it can.
    QString refusal(const QAction* action, const QKeySequence& key) const;
    /// In the place of all keys that it has; an empty one: none.
    void choose(QAction* action, const QKeySequence& key);
    void reset(QAction* action);

    /// Those that are not the actions' own: object name to keys, as QKeySequence::toString(PortableText) has them.
    QMap<QString, QString> choices() const;
    /// What cannot be is left out: files are edited by hand.
    void restore(const QMap<QString, QString>& choices);

  private:
    QList<QAction*> actions_;
    QMap<QAction*, QList<QKeySequence>> own_;
};

/// As a menu shows it, without its mnemonic.
QString plainText(const QAction& action);

}  // namespace pdr::ui
