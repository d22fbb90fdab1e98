#pragma once
/// Lists the window's actions with their keys, and gives them others.

#include <QDialog>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QTreeWidget>

#include "ui/keys/key_bindings.h"

namespace pdr::ui {

class KeysDialog : public QDialog {
    Q_OBJECT

  public:
    /// `bindings` outlives it.
    explicit KeysDialog(KeyBindings& bindings, QWidget* parent = nullptr);

  signals:
    /// Some action has another key now.
    void keysChanged();

  private:
    QAction* chosen() const;
    void showKeys();
    void showChosen();
    void take(const QKeySequence& key);
    void resetAll();

    KeyBindings& bindings_;
    QTreeWidget list_;
    QKeySequenceEdit edit_;
    QLabel refusal_;
};

}  // namespace pdr::ui
