#pragma once
/// The row of fields for when rendering stops: three limits, of which the first to be reached counts. Setters emit no
/// signals.

#include <QDoubleSpinBox>
#include <QSpinBox>
#include <QWidget>

#include "render/accuracy/stop_rule.h"

namespace pdr::ui {

class StopRow : public QWidget {
    Q_OBJECT

  public:
    explicit StopRow(QWidget* parent = nullptr);

    void setRule(const StopRule& rule);
    StopRule rule() const;

  signals:
    /// Reports a completed value: after Enter, on leaving the field, or by the arrow keys.
    void ruleChosen(const pdr::StopRule& rule);

  private:
    QDoubleSpinBox* levels_;
    QDoubleSpinBox* seconds_;  ///< at its minimum: no limit
    QSpinBox* samples_;        ///< at its minimum: no limit
};

}  // namespace pdr::ui
