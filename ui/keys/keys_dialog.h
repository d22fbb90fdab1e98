#pragma once
/// The dialog that lists the window's actions with their keys and changes them.

#include <QDialog>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QTreeWidget>

#include "ui/keys/key_bindings.h"

namespace pdr::ui {

class KeysDialog : public QDialog {
    Q_OBJECT

  public:
    /// Creates the dialog. `bindings` must outlive it.
    explicit KeysDialog(KeyBindings& bindings, QWidget* parent = nullptr);

  signals:
    /// Reports that the keys of an action have changed.
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
