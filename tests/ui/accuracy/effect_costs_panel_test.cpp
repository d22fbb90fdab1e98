/// The cost table of the effects: what it shows, and that it asks before it leaves something out.

#include <QSignalSpy>
#include <QTest>

#include "ui/accuracy/effect_costs.h"

namespace pdr::ui {

static EffectRows twoEffects() {
    EffectRows rows;
    rows.needed = {
        {"shadows", "light crosses tissue on its way", "2.31 (2.04 to 2.70)", "51 % (42 to 55)", "65.7 (62.9 to 68.3)",
         "122.3 (115.8 to 128.8)", "36 % (22 to 60)"},
        {"highlights", "a point of the curve is specular", "< 0.47", "< 11 %", "0", "0", "100 % (97 to 103)", true}};
    rows.off = {"emission: no point of the curve emits light", "depth of field: the aperture is 0"};
    rows.how = "Measured on an image of 96 x 70 pixels";
    rows.leftOut = {"highlights (the image changes by 0.00 levels)"};
    rows.complete = true;
    return rows;
}

/// Returns the visible label that contains `words`; null: there is none.
static QLabel* labelWith(const QWidget& panel, const QString& words) {
    for (QLabel* label : panel.findChildren<QLabel*>())
        if (!label->isHidden() && label->text().contains(words) && label->isVisibleTo(&panel))
            return label;
    return nullptr;
}

static QPushButton* button(const QWidget& panel, const QString& text) {
    for (QPushButton* one : panel.findChildren<QPushButton*>())
        if (one->text() == text)
            return one;
    qFatal("there is no button %s", qPrintable(text));
}

class TestEffectCosts : public QObject {
    Q_OBJECT

  private slots:
    void everyFigureIsShown();
    void figuresOfTheViewBeforeAreMarked();
    void whatIsOffIsNamedWithItsReason();
    void nothingIsLeftOutWithoutAQuestion();
    void theQuestionGoesWithWhatItAsked();
    void whereNothingCanBeLeftOutNothingIsOffered();
    void itTakesTheSameRoomWhateverItShows();
};

void TestEffectCosts::everyFigureIsShown() {
    EffectCosts panel;
    QVERIFY(!labelWith(panel, "share"));  // no titles of nothing
    panel.setRows(twoEffects());
    for (const char* words : {"shadows", "light crosses tissue", "2.31", "2.04 to 2.70", "51 %", "65.7", "122.3",
                              "36 %", "&lt; 0.47", "share", "96 x 70"})
        QVERIFY2(labelWith(panel, words), words);
    panel.setRows({});
    QVERIFY(!labelWith(panel, "shadows") && !labelWith(panel, "share"));
}

void TestEffectCosts::figuresOfTheViewBeforeAreMarked() {
    EffectCosts panel;
    panel.setRows(twoEffects());
    QVERIFY(labelWith(panel, "97 to 103")->font().italic());
    QVERIFY(!labelWith(panel, "22 to 60")->font().italic());
}

void TestEffectCosts::whatIsOffIsNamedWithItsReason() {
    EffectCosts panel;
    panel.setRows(twoEffects());
    const QLabel* off = labelWith(panel, "emission, depth of field");
    QVERIFY(off && off->toolTip().contains("no point of the curve emits light"));
}

void TestEffectCosts::nothingIsLeftOutWithoutAQuestion() {
    EffectCosts panel;
    panel.setRows(twoEffects());
    QSignalSpy chosen(&panel, &EffectCosts::leaveOutChosen);
    button(panel, "Turn off effects that do not show")->click();
    QVERIFY(labelWith(panel, "Turns off highlights (the image changes by 0.00 levels)"));
    QCOMPARE(chosen.size(), 0);
    button(panel, "Keep all")->click();
    QVERIFY(!labelWith(panel, "Turns off") && chosen.isEmpty());
    button(panel, "Turn off effects that do not show")->click();
    button(panel, "Turn off")->click();
    QVERIFY(!labelWith(panel, "Turns off"));
    QCOMPARE(chosen.size(), 1);
}

void TestEffectCosts::theQuestionGoesWithWhatItAsked() {
    EffectCosts panel;
    EffectRows rows = twoEffects();
    panel.setRows(rows);
    button(panel, "Turn off effects that do not show")->click();
    rows.how = "a little later";
    panel.setRows(rows);
    QVERIFY(labelWith(panel, "Turns off"));
    rows.leftOut = {"something else"};
    panel.setRows(rows);
    QVERIFY(!labelWith(panel, "Turns off"));
}

void TestEffectCosts::whereNothingCanBeLeftOutNothingIsOffered() {
    EffectCosts panel;
    EffectRows rows = twoEffects();
    rows.leftOut.clear();
    panel.setRows(rows);
    const QPushButton* only = button(panel, "Turn off effects that do not show");
    QVERIFY(!only->isEnabled() && labelWith(panel, "all active effects are needed"));
    panel.setRows(twoEffects());
    QVERIFY(only->isEnabled() && !labelWith(panel, "all active effects are needed"));
}

/// Otherwise the image would begin anew with each row.
void TestEffectCosts::itTakesTheSameRoomWhateverItShows() {
    EffectCosts panel;
    const QSize empty = panel.sizeHint(), least = panel.minimumSizeHint();
    panel.setRows(twoEffects());
    QCOMPARE(panel.sizeHint().height(), empty.height());
    QVERIFY(panel.minimumSizeHint().height() == least.height() && least.height() < empty.height());
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestEffectCosts)
#include "effect_costs_panel_test.moc"
