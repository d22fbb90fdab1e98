#pragma once
/// The keys of the window's actions: the defaults, or what the user chose instead.

#include <QAction>
#include <QList>
#include <QMap>
#include <QString>

namespace pdr::ui {

class KeyBindings {
  public:
    /// Takes the actions with their default keys. Each must have an object name, under which choices are saved.
    explicit KeyBindings(const QList<QAction*>& actions);

    const QList<QAction*>& actions() const { return actions_; }
    const QList<QKeySequence>& ownKeys(QAction* action) const { return own_.find(action).value(); }
    /// Returns why `action` cannot have that key, naming what has it; empty: it can.
    QString refusal(const QAction* action, const QKeySequence& key) const;
    /// Replaces all keys of `action`. An empty key: none.
    void choose(QAction* action, const QKeySequence& key);
    void reset(QAction* action);

    /// Returns the keys that differ from the defaults: object name to keys, as QKeySequence::toString(PortableText)
    /// writes them.
    QMap<QString, QString> choices() const;
    /// Restores saved choices. Invalid ones are ignored, since files are edited by hand.
    void restore(const QMap<QString, QString>& choices);

  private:
    QList<QAction*> actions_;
    QMap<QAction*, QList<QKeySequence>> own_;
};

/// Returns the text of an action without its mnemonic and dots.
QString plainText(const QAction& action);

}  // namespace pdr::ui
