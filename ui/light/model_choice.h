#pragma once
/// The choice of the light transport model, in the user's words, with what it shows and what it costs. Setters emit no
/// signals.

#include <QComboBox>
#include <QLabel>
#include <QWidget>
#include <optional>

#include "render/scene/model.h"

namespace pdr::ui {

/// The measured cost of another model and the change that it makes.
struct ModelCost {
    Model before;       ///< the model compared with
    double timeFactor;  ///< time per sample, relative to `before`
    double levels;      ///< 95 % of the image changes by no more of 255 grey levels
};

class ModelChoice : public QWidget {
    Q_OBJECT

  public:
    explicit ModelChoice(QWidget* parent = nullptr);

    /// Sets the model; another one discards the cost.
    void setModel(Model model);
    /// Sets the cost of the current model. None: not known.
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

/// Returns the name of a model: "Lit surfaces".
QString modelTitle(Model model);
/// Returns what images of a model show, and what they do not: a sentence or two.
QString modelText(Model model);
/// Returns "A sample takes about 2.1 times as long as with “Lit surfaces”; 95 % of the image changes by at most 12 of
/// 255 levels."
QString costText(const ModelCost& cost);

}  // namespace pdr::ui
