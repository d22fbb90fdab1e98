#include "ui/look_panel.h"

#include <QLabel>
#include <QSignalBlocker>
#include <cmath>

namespace pdr::ui {
namespace {

constexpr int kStepsPerStop = 10;
constexpr int kStops = 4;

}  // namespace

LookPanel::LookPanel(QWidget* parent) : QWidget(parent), presetColumn_(new QVBoxLayout), brightness_(Qt::Horizontal) {
    presetColumn_->setSpacing(4);
    connect(&presets_, &QButtonGroup::idClicked, this, &LookPanel::presetChosen);

    brightness_.setAccessibleName(tr("Brightness"));
    brightness_.setToolTip(tr("Brighter to the right. It changes what is shown, not what is computed."));
    brightness_.setRange(-kStops * kStepsPerStop, kStops * kStepsPerStop);
    const auto choose = [this] {
        emit brightnessChosen(double(brightness_.value()) / kStepsPerStop, brightness_.isSliderDown());
    };
    connect(&brightness_, &QSlider::valueChanged, this, choose);
    connect(&brightness_, &QSlider::sliderReleased, this, choose);

    pause_.setAccessibleName(tr("Pause"));
    pause_.setToolTip(tr("Hold the rendering, or let it go on (Space)"));
    pause_.setCheckable(true);
    connect(&pause_, &QPushButton::clicked, this, &LookPanel::pauseChosen);
    setPaused(false);

    tissue_.setText(tr("&Tissue..."));
    tissue_.setAccessibleName(tr("Edit the tissue"));
    tissue_.setToolTip(tr("Curves and colours over Hounsfield units (F5)"));
    connect(&tissue_, &QPushButton::clicked, this, &LookPanel::tissueWanted);

    light_.setText(tr("&Light..."));
    light_.setAccessibleName(tr("Edit the light"));
    light_.setToolTip(tr("Where the light comes from (F8)"));
    connect(&light_, &QPushButton::clicked, this, &LookPanel::lightWanted);

    auto* brightnessLabel = new QLabel(tr("&Brightness"));
    brightnessLabel->setBuddy(&brightness_);

    // A click leaves the keyboard with the picture, so that Space goes on to mean pause; Tab still reaches everything.
    for (QWidget* control : std::initializer_list<QWidget*>{&tissue_, &light_, &brightness_, &pause_})
        control->setFocusPolicy(Qt::TabFocus);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 8, 10, 10);
    column->setSpacing(8);
    column->addLayout(presetColumn_);
    column->addWidget(&tissue_);
    column->addWidget(&light_);
    column->addSpacing(14);
    column->addWidget(brightnessLabel);
    column->addWidget(&brightness_);
    column->addStretch(1);
    column->addWidget(&pause_);
}

void LookPanel::setPresets(const QStringList& names) {
    qDeleteAll(presets_.buttons());
    for (int i = 0; i < names.size(); ++i) {
        auto* button = new QPushButton(names[i]);
        button->setAccessibleName(tr("Preset %1").arg(names[i]));
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        presets_.addButton(button, i);
        presetColumn_->addWidget(button);
    }
}

void LookPanel::setPreset(int index) {
    presets_.setExclusive(false);  // so that none may be chosen
    for (QAbstractButton* button : presets_.buttons())
        button->setChecked(presets_.id(button) == index);
    presets_.setExclusive(true);
}

void LookPanel::setBrightness(double stops) {
    const QSignalBlocker silent(this);
    brightness_.setValue(int(std::lround(stops * kStepsPerStop)));
}

void LookPanel::setPaused(bool paused) {
    pause_.setChecked(paused);
    pause_.setText(paused ? tr("Go on") : tr("Pause"));
}

}  // namespace pdr::ui
