#pragma once
/// Which part of the patient is shown, and how much is peeled off it. Setters are silent.

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QWidget>

#include "render/scene/visible.h"

namespace pdr::ui {

class VisibleRow : public QWidget {
    Q_OBJECT

  public:
    explicit VisibleRow(QWidget* parent = nullptr);

    void setChoice(const Visible& visible);
    /// What the picture does not show, in sentences; empty: nothing is hidden.
    void setNotShown(const QString& sentences);

  signals:
    void chosen(const pdr::Visible& visible);

  private:
    void choose();

    QComboBox part_;
    QDoubleSpinBox peel_;
    QLabel notShown_;
};

}  // namespace pdr::ui
