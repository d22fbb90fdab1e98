#pragma once
/// Which picture is made of the volume, in the user's words, with what it shows and what it costs. Setters are silent.

#include <QComboBox>
#include <QLabel>
#include <QWidget>
#include <optional>

#include "render/scene/model.h"

namespace pdr::ui {

/// What another model takes and changes, measured.
struct ModelCost {
    Model before;       ///< it is compared with
    double timeFactor;  ///< so many times as long does a sample take
    double levels;      ///< 95 % of the picture changes by no more of 255 grey levels
};

class ModelChoice : public QWidget {
    Q_OBJECT

  public:
    explicit ModelChoice(QWidget* parent = nullptr);

    /// Another model forgets the cost.
    void setModel(Model model);
    /// Of the model that is shown; none: not known.
    void setCost(const std::optional<ModelCost>& cost);

  signals:
    void modelChosen(pdr::Model model);

  private:
    void fill();

    Model model_ = Model::singleScattering;
    std::optional<ModelCost> cost_;
    QComboBox models_;
    QLabel text_;
};

/// "Lit surfaces".
QString modelTitle(Model model);
/// What its pictures show, and what they do not: a sentence or two.
QString modelText(Model model);
/// "A sample takes about 2.1 times as long as with \"Lit surfaces\"; 95 % of the picture changes by at most 12 of 255
/// levels."
QString costText(const ModelCost& cost);

}  // namespace pdr::ui
