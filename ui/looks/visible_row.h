#pragma once
/// The choice of which part of the patient is shown, and how much is peeled off it. Setters emit no signals.

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
    /// Sets the sentences on what the image does not show. Empty: nothing is hidden.
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
