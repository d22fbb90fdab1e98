#pragma once
/// What the seconds go to: a calm table of the effects that a scene calls for, with what each costs and brings, and a
/// button that leaves out what nobody would see. Setters are silent.

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace pdr::ui {

/// An effect that is needed. Figures are as render/accuracy/ledger_text.h has them, empty where there are none.
struct EffectRow {
    QString name, reason;
    QString milliseconds, share;
    QString meanLevels, levels95;
    QString time;
    bool ofViewBefore = false;  ///< the figures are
};

/// All that the panel shows.
struct EffectRows {
    QList<EffectRow> needed;
    QStringList off;        ///< effects with the reason: "emission: no node emits light"
    QString how;            ///< a sentence: on what it was measured, and how far measuring is
    QStringList leftOut;    ///< what the button would leave out, and what that changes: phrases; empty: nothing
    bool complete = false;  ///< no more will be known
};

class EffectLedger : public QWidget {
    Q_OBJECT

  public:
    explicit EffectLedger(QWidget* parent = nullptr);

    void setRows(const EffectRows& rows);

    /// Whatever it shows, so that the picture beside it keeps its size.
    QSize sizeHint() const override;

  signals:
    /// What was listed is to be left out; the hand has confirmed it.
    void leaveOutChosen();

  private:
    void layOut();
    void fill();
    void ask();
    void answer(bool leaveOut);
    void showQuestion(bool shown);

    EffectRows rows_;
    QGridLayout* table_;
    QLabel* off_;
    QLabel* how_;
    QPushButton* onlyNeeded_;
    QWidget* statement_;  ///< how it was measured, and the button; the question takes its place
    QWidget* question_;
    QLabel* questionText_;
    QPushButton* leaveOut_;
    QPushButton* keep_;
};

}  // namespace pdr::ui
