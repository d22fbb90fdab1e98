#include "ui/keys/keys_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace pdr::ui {

KeysDialog::KeysDialog(KeyBindings& bindings, QWidget* parent) : QDialog(parent), bindings_(bindings) {
    setWindowTitle(tr("Edit keys"));
    resize(520, 560);
    // Fill the list and the buttons
    list_.setAccessibleName(tr("Actions and their keys"));
    list_.setColumnCount(2);
    list_.setHeaderLabels({tr("Action"), tr("Keys")});
    list_.setRootIsDecorated(false);
    list_.header()->setSectionResizeMode(0, QHeaderView::Stretch);
    for (const QAction* action : bindings_.actions())
        list_.addTopLevelItem(new QTreeWidgetItem({plainText(*action)}));
    edit_.setAccessibleName(tr("Key of the chosen action"));
    refusal_.setWordWrap(true);
    refusal_.setAccessibleName(tr("Why this key cannot be used"));
    auto* none = new QPushButton(tr("&No key"));
    auto* own = new QPushButton(tr("&Default"));
    auto* allOwn = new QPushButton(tr("&All defaults"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    for (QPushButton* button : {none, own, allOwn}) {
        button->setAutoDefault(false);
        buttons->addButton(button, QDialogButtonBox::ActionRole);
    }

    // Lay them out in a column
    auto* column = new QVBoxLayout(this);
    column->addWidget(&list_, 1);
    column->addWidget(new QLabel(tr("Choose an action, click below, and press its new key.")));
    column->addWidget(&edit_);
    column->addWidget(&refusal_);
    column->addWidget(buttons);

    connect(&list_, &QTreeWidget::currentItemChanged, this, &KeysDialog::showChosen);
    connect(&edit_, &QKeySequenceEdit::editingFinished, this, [this] { take(edit_.keySequence()); });
    connect(none, &QPushButton::clicked, this, [this] { take({}); });
    connect(own, &QPushButton::clicked, this, [this] { take(bindings_.ownKeys(chosen()).value(0)); });
    connect(allOwn, &QPushButton::clicked, this, &KeysDialog::resetAll);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    list_.setCurrentItem(list_.topLevelItem(0));
    showKeys();
}

QAction* KeysDialog::chosen() const {
    return bindings_.actions()[list_.indexOfTopLevelItem(list_.currentItem())];
}

void KeysDialog::showKeys() {
    for (int i = 0; i < list_.topLevelItemCount(); ++i)
        list_.topLevelItem(i)->setText(
            1, QKeySequence::listToString(bindings_.actions()[i]->shortcuts(), QKeySequence::NativeText));
}

void KeysDialog::showChosen() {
    const QSignalBlocker silent(&edit_);
    edit_.setKeySequence(chosen()->shortcut());
    refusal_.clear();
}

/// Gives the chosen action a key. Only the first of several typed keys is used.
void KeysDialog::take(const QKeySequence& key) {
    const QKeySequence first = key.isEmpty() ? key : QKeySequence(key[0]);
    const QString refusal = bindings_.refusal(chosen(), first);
    if (refusal.isEmpty() && first != chosen()->shortcut()) {
        if (first == bindings_.ownKeys(chosen()).value(0))
            bindings_.reset(chosen());
        else
            bindings_.choose(chosen(), first);
        emit keysChanged();
    }
    showKeys();
    showChosen();
    refusal_.setText(refusal);
}

void KeysDialog::resetAll() {
    for (QAction* action : bindings_.actions())
        bindings_.reset(action);
    showKeys();
    showChosen();
    emit keysChanged();
}

}  // namespace pdr::ui
