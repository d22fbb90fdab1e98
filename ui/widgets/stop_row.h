#pragma once
/// When rendering holds: three limits in a row, of which the first that is reached counts. Setters are silent.

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
    /// When a value is complete: after Enter, on leaving the field, or by its arrows.
    void ruleChosen(const pdr::StopRule& rule);

  private:
    QDoubleSpinBox* levels_;
    QDoubleSpinBox* seconds_;  ///< at its minimum: no limit
    QSpinBox* samples_;        ///< at its minimum: no limit
};

}  // namespace pdr::ui
