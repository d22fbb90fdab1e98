/// The list of measurements.

#include <QAction>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "ui/measure/marks_panel.h"

namespace pdr::ui {
namespace {

const std::vector<MarkRow> kRows{{11, "Distance 1", "42.3 ± 0.5 mm", "Grid ±0.4."},
                                 {12, "defect", "at most 2.9 mm", ""}};

}  // namespace

class MarksPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void settersAreSilent() {
        MarksPanel panel;
        QSignalSpy selected(&panel, &MarksPanel::selected), renamed(&panel, &MarksPanel::renamed);
        panel.setRows(kRows);
        panel.setSelected(12);
        panel.setRows({kRows[1]});
        QVERIFY(selected.isEmpty() && renamed.isEmpty());
    }

    void aToolsButtonIsItsAction() {
        MarksPanel panel;
        QAction action("&Distance");
        action.setCheckable(true);
        panel.addTool(&action);
        auto* button = panel.findChildren<QToolButton*>().last();
        QSignalSpy triggered(&action, &QAction::triggered);
        button->click();
        QVERIFY(triggered.size() == 1 && button->isChecked());
        action.setEnabled(false);
        QVERIFY(!button->isEnabled());
    }

    /// Whoever has marked a place types at once what it is.
    void aNameIsOpenedForTyping() {
        MarksPanel panel;
        panel.setRows(kRows);
        panel.show();
        panel.editName(12);
        auto* line = panel.findChild<QLineEdit*>();
        QVERIFY(line && line->text() == "defect");
        QSignalSpy renamed(&panel, &MarksPanel::renamed);
        QTest::keyClicks(line, "nerve");
        QTest::keyClick(line, Qt::Key_Return);
        QTRY_COMPARE(renamed.size(), 1);
        QCOMPARE(renamed[0][0].toULongLong(), 12u);
        QCOMPARE(renamed[0][1].toString(), QString("nerve"));
    }

    void valuesAndTheirCausesAreShown() {
        MarksPanel panel;
        panel.setRows(kRows);
        const auto* list = panel.findChild<QTreeWidget*>();
        QCOMPARE(list->topLevelItemCount(), 2);
        QCOMPARE(list->topLevelItem(0)->text(1), QString::fromUtf8("42.3 ± 0.5 mm"));
        QCOMPARE(list->topLevelItem(0)->toolTip(1), QString::fromUtf8("Grid ±0.4."));
    }

    void renamingAndRemovingNameTheMeasurement() {
        MarksPanel panel;
        panel.setRows(kRows);
        auto* list = panel.findChild<QTreeWidget*>();
        QSignalSpy renamed(&panel, &MarksPanel::renamed), removed(&panel, &MarksPanel::removed);
        list->topLevelItem(1)->setText(0, "left orbit");
        QCOMPARE(renamed.size(), 1);
        QCOMPARE(renamed[0][0].toULongLong(), 12u);
        QCOMPARE(renamed[0][1].toString(), QString("left orbit"));
        QTest::keyClick(list, Qt::Key_Delete);  // nothing is selected
        QVERIFY(removed.isEmpty());
        panel.setSelected(11);
        QTest::keyClick(list, Qt::Key_Delete);
        QCOMPARE(removed.size(), 1);
        QCOMPARE(removed[0][0].toULongLong(), 11u);
    }

    void theSelectionStaysWithItsMeasurement() {
        MarksPanel panel;
        panel.setRows(kRows);
        panel.setSelected(12);
        panel.setRows({{5, "new", "1 mm", ""}, kRows[0], kRows[1]});
        const auto* list = panel.findChild<QTreeWidget*>();
        QCOMPARE(list->currentItem(), list->topLevelItem(2));
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::MarksPanelTest)
#include "marks_panel_test.moc"
