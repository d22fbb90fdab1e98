#pragma once
/// The choice of which parts of the patient are shown, and how much is peeled off it. Setters emit no signals.

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QWidget>
#include <vector>

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
    /// Returns what the list calls these parts: "Only bones", "All but bones", "Only the lungs without bones".
    static QString choiceText(const Visible& parts);
    /// Adds the choice of these parts to the list, if it is not there yet, and returns its place.
    int indexOf(const Visible& parts);

    QComboBox part_;
    std::vector<Visible> choices_;  ///< the parts of each entry of the list, not peeled
    QDoubleSpinBox peel_;
    QLabel notShown_;
};

}  // namespace pdr::ui
