/// The keys of the window's actions: all are listed, each can be changed, and no key has two meanings.

#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "ui/keys/keys_dialog.h"
#include "ui/window/main_window.h"

namespace pdr::ui {

class TestKeysDialog : public QObject {
    Q_OBJECT

  private slots:
    void anActionTakesAnotherKey();
    void aKeyThatIsTakenIsNamed();
    void keysOfTheImageStay();
    void choicesComeBackAndDefaultsToo();
    void keysMayBeSwappedInTheFile();
    void everyActionOfTheWindowIsListedAndExplained();
};

struct Hand {
    Hand() : actions(3) {
        const char* names[] = {"one", "two", "three"};
        for (int i = 0; i < 3; ++i) {
            actions[i].setObjectName(names[i]);
            actions[i].setText(QString("&") + names[i]);
            actions[i].setShortcut(Qt::Key(Qt::Key_1 + i));
            list << &actions[i];
        }
        actions[2].setShortcuts({QKeySequence(Qt::Key_H), QKeySequence(Qt::Key_Question)});
    }
    std::vector<QAction> actions;
    QList<QAction*> list;
};

static void press(KeysDialog& dialog, int row, Qt::Key key) {
    dialog.findChild<QTreeWidget*>()->setCurrentItem(dialog.findChild<QTreeWidget*>()->topLevelItem(row));
    auto* edit = dialog.findChild<QKeySequenceEdit*>();
    edit->setKeySequence(QKeySequence(key));
    emit edit->editingFinished();
}

void TestKeysDialog::anActionTakesAnotherKey() {
    Hand hand;
    KeyBindings bindings(hand.list);
    KeysDialog dialog(bindings);
    QSignalSpy changed(&dialog, &KeysDialog::keysChanged);
    press(dialog, 1, Qt::Key_Q);
    QCOMPARE(hand.actions[1].shortcut(), QKeySequence(Qt::Key_Q));
    QCOMPARE(bindings.choices(), (QMap<QString, QString>{{"two", "Q"}}));
    QCOMPARE(changed.count(), 1);
    QCOMPARE(dialog.findChild<QTreeWidget*>()->topLevelItem(1)->text(1), QString("Q"));
}

void TestKeysDialog::aKeyThatIsTakenIsNamed() {
    Hand hand;
    KeyBindings bindings(hand.list);
    KeysDialog dialog(bindings);
    QSignalSpy changed(&dialog, &KeysDialog::keysChanged);
    press(dialog, 0, Qt::Key_Question);
    QCOMPARE(hand.actions[0].shortcut(), QKeySequence(Qt::Key_1));
    QVERIFY(changed.isEmpty());
    QStringList said;
    for (const QLabel* label : dialog.findChildren<QLabel*>())
        said << label->text();
    QVERIFY2(said.join('\n').contains("? belongs to \"three\""), qPrintable(said.join('\n')));
}

void TestKeysDialog::keysOfTheImageStay() {
    Hand hand;
    const KeyBindings bindings(hand.list);
    for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Escape, Qt::Key_Plus})
        QVERIFY(!bindings.refusal(hand.list[0], QKeySequence(key)).isEmpty());
    QVERIFY(bindings.refusal(hand.list[0], QKeySequence(Qt::CTRL | Qt::Key_Left)).isEmpty());
}

void TestKeysDialog::choicesComeBackAndDefaultsToo() {
    Hand hand;
    KeyBindings bindings(hand.list);
    bindings.restore({{"one", "Ctrl+J"}, {"two", "H"}, {"three", ""}, {"nobody", "K"}});
    QCOMPARE(hand.actions[0].shortcut(), QKeySequence(Qt::CTRL | Qt::Key_J));
    QVERIFY(hand.actions[2].shortcuts().isEmpty());
    QCOMPARE(hand.actions[1].shortcut(), QKeySequence(Qt::Key_H));
    KeysDialog dialog(bindings);
    for (QPushButton* button : dialog.findChildren<QPushButton*>())
        if (button->text() == "&All defaults")
            button->click();
    QVERIFY(bindings.choices().isEmpty());
    QCOMPARE(hand.actions[2].shortcuts().size(), 2);
}

void TestKeysDialog::keysMayBeSwappedInTheFile() {
    Hand hand;
    KeyBindings bindings(hand.list);
    bindings.restore({{"one", "2"}, {"two", "1"}});
    QCOMPARE(hand.actions[0].shortcut(), QKeySequence(Qt::Key_2));
    QCOMPARE(hand.actions[1].shortcut(), QKeySequence(Qt::Key_1));
}

/// A tool tip must explain more than the menu text, except for undo, whose text is complete.
void TestKeysDialog::everyActionOfTheWindowIsListedAndExplained() {
    MainWindow window;
    QMap<QString, QString> keys;
    for (const QAction* action : window.findChildren<QAction*>()) {
        if (action->shortcuts().isEmpty() || action->isSeparator())
            continue;
        QVERIFY2(!action->objectName().isEmpty(), qPrintable(action->text()));
        const bool undo = action->objectName() == "undo" || action->objectName() == "redo";
        QVERIFY2(undo || (action->toolTip().endsWith('.') && action->toolTip() != plainText(*action)),
                 qPrintable(action->objectName() + ": " + action->toolTip()));
        for (const QKeySequence& key : action->shortcuts()) {
            QVERIFY2(!keys.contains(key.toString()), qPrintable(key.toString()));
            keys[key.toString()] = action->objectName();
        }
    }
    QVERIFY(keys.size() > 20);
    window.setKeys({{"denoised", "Ctrl+Alt+S"}});
    QVERIFY(std::ranges::any_of(window.findChildren<QAction*>(), [](const QAction* action) {
        return action->objectName() == "denoised" && action->shortcut() == QKeySequence("Ctrl+Alt+S");
    }));
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestKeysDialog)
#include "keys_dialog_test.moc"
