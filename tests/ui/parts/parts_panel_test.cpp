/// The list of parts, and what can be chosen for them.

#include <QSignalSpy>
#include <QTest>

#include "ui/parts/parts_panel.h"

namespace pdr::ui {
namespace {

const std::vector<PartRow> kRows{{.name = "Rest of the body", .state = "shown"},
                                 {"liver", QColor(10, 20, 30), "1500 ml", "ghost", "file", "Bone", "A label map."},
                                 {"spleen", QColor(40, 50, 60), "200 ml", "hidden", "program", "", "A rule."}};

QAbstractButton& button(PartsPanel& panel, const QString& text) {
    for (auto* button : panel.findChildren<QAbstractButton*>())
        if (button->text().remove('&') == text)
            return *button;
    qFatal("no such button");
}

QTreeWidget& list(PartsPanel& panel) {
    return *panel.findChild<QTreeWidget*>();
}

}  // namespace

class PartsPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void partsAreListed() {
        PartsPanel panel;
        panel.setRows(kRows);
        QCOMPARE(list(panel).topLevelItemCount(), 3);
        const QTreeWidgetItem& liver = *list(panel).topLevelItem(1);
        QCOMPARE(liver.text(0) + liver.text(1) + liver.text(2) + liver.text(3), QString("liver1500 mlghostfile"));
        QVERIFY(liver.toolTip(0).contains("A label map.") && liver.toolTip(0).contains("Bone"));
        QCOMPARE(liver.icon(0).pixmap(8).toImage().pixelColor(3, 3), QColor(10, 20, 30));
    }

    /// Many parts are changed together; the rest of the body has the look's own curve.
    void whatIsSelectedIsChanged() {
        PartsPanel panel;
        panel.setRows(kRows);
        panel.setLooks({"Bone", "Skin & hair"});
        QSignalSpy state(&panel, &PartsPanel::stateChosen), look(&panel, &PartsPanel::lookChosen);
        QVERIFY(!button(panel, "Ghost").isEnabled() && !button(panel, "Colour...").isEnabled());
        list(panel).topLevelItem(0)->setSelected(true);
        QVERIFY(button(panel, "Ghost").isEnabled() && !button(panel, "Colour...").isEnabled());
        list(panel).topLevelItem(2)->setSelected(true);
        QVERIFY(button(panel, "Colour...").isEnabled());
        button(panel, "Hide").click();
        QCOMPARE(state.size(), 1);
        QVERIFY(state[0][0].value<std::vector<int>>() == (std::vector{0, 2}));
        QVERIFY(state[0][1].value<PartState>() == PartState::hidden);
        const QList<QAction*> looks = panel.findChild<QToolButton*>()->menu()->actions();
        QCOMPARE(looks.last()->text(), QString("Skin && hair"));
        looks.last()->trigger();
        looks.first()->trigger();
        QVERIFY(look.size() == 2 && look[0][1].toInt() == 1 && look[1][1].toInt() == -1);
    }

    /// An edit brings new rows, and the next one is of the same parts.
    void theSelectionStays() {
        PartsPanel panel;
        QSignalSpy state(&panel, &PartsPanel::stateChosen);
        panel.setRows(kRows);
        list(panel).topLevelItem(1)->setSelected(true);
        std::vector<PartRow> changed = kRows;
        changed[1].state = "hidden";
        panel.setRows(changed);
        QVERIFY(panel.selected() == std::vector{1} && state.isEmpty());
        panel.setRows({kRows[0], kRows[2]});
        QVERIFY(panel.selected().empty());
        panel.setRows({});
        QVERIFY(!button(panel, "Remove all parts").isEnabled());
    }

    void oneThingIsFoundAtATime() {
        PartsPanel panel;
        QSignalSpy vessels(&panel, &PartsPanel::vesselsWanted), file(&panel, &PartsPanel::labelFileWanted);
        panel.setBusy(true);
        button(panel, "Find vessels").click();
        QVERIFY(vessels.isEmpty());
        panel.setBusy(false);
        button(panel, "Find vessels").click();
        button(panel, "Open label map...").click();
        QVERIFY(vessels.size() == 1 && file.size() == 1);
    }

    void itsControlsAreNamed() {
        PartsPanel panel;
        panel.setRows(kRows);
        panel.setNotes("Found by the program: check it.");
        QVERIFY(!list(panel).accessibleName().isEmpty());
        for (auto* button : panel.findChildren<QAbstractButton*>())
            QVERIFY2(!button->text().isEmpty() || !button->accessibleName().isEmpty(),
                     button->metaObject()->className());
        QVERIFY(panel.findChild<QLabel*>()->text().contains("check it"));
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::PartsPanelTest)
#include "parts_panel_test.moc"
