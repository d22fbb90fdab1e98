#pragma once
/// The cost table of the effects: for each effect needed by the scene, its cost and what it changes, and a button to
/// leave out effects without a visible result. Setters emit no signals.

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace pdr::ui {

/// An effect that the scene calls for. The figures are formatted by render/accuracy/effect_cost_text.h; empty if not
/// known.
struct EffectRow {
    QString name, reason;
    QString milliseconds, share;
    QString meanLevels, levels95;
    QString time;
    bool ofViewBefore = false;  ///< the figures are from the previous view
};

/// The content of the table.
struct EffectRows {
    QList<EffectRow> needed;
    QStringList off;        ///< effects that are off, with the reason: "emission: no node emits light"
    QString how;            ///< a sentence: on what the costs were measured, and how far measuring is
    QStringList leftOut;    ///< what the button would leave out, and what that changes: phrases; empty: nothing
    bool complete = false;  ///< measuring is complete
};

class EffectCosts : public QWidget {
    Q_OBJECT

  public:
    explicit EffectCosts(QWidget* parent = nullptr);

    void setRows(const EffectRows& rows);

    /// Returns a size that does not depend on the content, so that the image beside the table keeps its size.
    QSize sizeHint() const override;

  signals:
    /// Requests to leave out the listed effects, after the user has confirmed it.
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
    QWidget* statement_;  ///< how it was measured, and the button; replaced by the question
    QWidget* question_;
    QLabel* questionText_;
    QPushButton* leaveOut_;
    QPushButton* keep_;
};

}  // namespace pdr::ui
