#include "ui/light/model_choice.h"

#include <QVBoxLayout>
#include <algorithm>
#include <array>

namespace pdr::ui {
namespace {

/// The models to choose from; the others are available in scene files only.
constexpr std::array kOffered{Model::singleScattering, Model::multipleScattering, Model::absorption,
                              Model::maximumIntensity};

constexpr double kSmall = 0.9;  ///< font size relative to the usual one

}  // namespace

ModelChoice::ModelChoice(QWidget* parent) : QWidget(parent) {
    for (const Model model : kOffered)
        models_.addItem(modelTitle(model));
    models_.setPlaceholderText(tr("Another"));
    models_.setAccessibleName(tr("What is shown"));
    models_.setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // long names must not widen the panel
    models_.setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard focus with the image
    for (int i = 0; i < int(kOffered.size()); ++i)
        models_.setItemData(i, modelText(kOffered[std::size_t(i)]), Qt::ToolTipRole);
    text_.setWordWrap(true);
    QFont small = text_.font();
    small.setPointSizeF(kSmall * small.pointSizeF());
    text_.setFont(small);
    text_.setAccessibleName(tr("What it shows and costs"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(&models_);
    column->addWidget(&text_);
    connect(&models_, &QComboBox::activated, this,
            [this](int index) { emit modelChosen(kOffered[std::size_t(index)]); });
    fill();
}

void ModelChoice::setModel(Model model) {
    if (model == model_)
        return;
    model_ = model;
    cost_.reset();
    fill();
}

void ModelChoice::setCost(const std::optional<ModelCost>& cost) {
    cost_ = cost;
    fill();
}

void ModelChoice::fill() {
    const auto offered = std::ranges::find(kOffered, model_);
    models_.setCurrentIndex(offered == kOffered.end() ? -1 : int(offered - kOffered.begin()));
    text_.setText(cost_ ? modelText(model_) + ' ' + costText(*cost_) : modelText(model_));
}

QString modelTitle(Model model) {
    switch (model) {
        case Model::singleScattering:
            return ModelChoice::tr("Lit surfaces");
        case Model::multipleScattering:
            return ModelChoice::tr("Translucent tissue (multiple scattering)");
        case Model::absorption:
            return ModelChoice::tr("X-ray");
        case Model::maximumIntensity:
            return ModelChoice::tr("Maximum intensity");
        case Model::emission:
            return ModelChoice::tr("Glowing tissue");
        case Model::emissionAbsorption:
            return ModelChoice::tr("Unlit tissue");
    }
    return {};
}

QString modelText(Model model) {
    switch (model) {
        case Model::singleScattering:
            return ModelChoice::tr("Light is scattered once: crisp surfaces and dark shadows.");
        case Model::multipleScattering:
            return ModelChoice::tr("Light is scattered on and on: soft, with light in the shadows.");
        case Model::absorption:
            return ModelChoice::tr(
                "Total attenuation along the line of sight, as in a radiograph. Lamps have no effect.");
        case Model::maximumIntensity:
            return ModelChoice::tr("The densest tissue on each line of sight; not which of two lies in front.");
        case Model::emission:
            return ModelChoice::tr("All tissue glows through all other. Lamps have no effect.");
        case Model::emissionAbsorption:
            return ModelChoice::tr("Tissue in its own colours, without light or shadow.");
    }
    return {};
}

QString costText(const ModelCost& cost) {
    const int digits = cost.timeFactor < 10 ? 1 : 0;
    return ModelChoice::
        tr("A sample takes about %1 times as long as with “%2”; 95 % of the image changes by at most %3 of 255 levels.")
            .arg(cost.timeFactor, 0, 'f', digits)
            .arg(modelTitle(cost.before))
            .arg(cost.levels, 0, 'f', 0);
}

}  // namespace pdr::ui
