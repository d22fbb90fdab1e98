#include "ui/light/light_panel.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/light/light_text.h"

namespace pdr::ui {
namespace {

constexpr int kStepsPerStop = 10;
constexpr int kDarkest = -6 * kStepsPerStop, kBrightest = 10 * kStepsPerStop;  ///< log2 of a lamp's irradiance
constexpr int kSmallest = -5 * kStepsPerStop, kLargest = 3 * kStepsPerStop;    ///< log2 of a lamp's edge [radii]
constexpr int kFaintest = -10 * kStepsPerStop, kGlaring = 4 * kStepsPerStop;   ///< log2 of the ambient radiance

int stepOf(double value) {
    return value > 0 ? int(std::lround(kStepsPerStop * std::log2(value))) : kDarkest * 100;
}

/// Returns the slider's value. `fromNone`: its lowest step means 0.
double valueAt(const QSlider& slider, bool fromNone) {
    const bool none = fromNone && slider.value() == slider.minimum();
    return none ? 0 : std::exp2(double(slider.value()) / kStepsPerStop);
}

}  // namespace

LightPanel::LightPanel(QWidget* parent) : QWidget(parent) {
    describeControls();
    layOut();
    connectParts();
    showLighting();
}

void LightPanel::describeControls() {
    const auto describe = [](QSlider& slider, int lowest, int highest, const QString& name, const QString& tip) {
        slider.setRange(lowest, highest);
        slider.setPageStep(kStepsPerStop);
        slider.setAccessibleName(name);
        slider.setToolTip(tip);
        slider.setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard focus with the image
    };
    describe(strength_, kDarkest, kBrightest, tr("Strength of the chosen lamp"),
             tr("How much light the chosen lamp brings; at the left end it is off"));
    describe(size_, kSmallest, kLargest, tr("Size of the chosen lamp"),
             tr("Small lamps throw hard shadows, large ones soft ones; the light stays as strong"));
    describe(ambient_, kFaintest, kGlaring, tr("Ambient light"), tr("Brightens shadows; none at the left end"));
    follows_.addItems({tr("the view"), tr("the patient")});
    follows_.setAccessibleName(tr("What the lamps move with"));
    follows_.setToolTip(
        tr("The view: each side is lit alike\nThe patient: the lamps stay where they are when the patient is turned"));
    follows_.setFocusPolicy(Qt::TabFocus);
    place_.setAlignment(Qt::AlignHCenter);
    place_.setAccessibleName(tr("The chosen lamp"));
    expert_.setText(tr("All panels in numbers"));
    expert_.setAccessibleName(tr("All panels in numbers"));
    expert_.setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    expert_.setArrowType(Qt::RightArrow);
    expert_.setCheckable(true);
    expert_.setAutoRaise(true);
    expert_.setFocusPolicy(Qt::TabFocus);
    table_.hide();
}

QWidget* LightPanel::rigButtons() {
    constexpr int kColumns = 2;
    auto* box = new QWidget;
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    for (const NamedRig name : kNamedRigs) {
        auto* button = new QPushButton(rigName(name));
        button->setToolTip(rigTip(name));
        button->setProperty("narrow", true);
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        rigs_.addButton(button, int(name));
        grid->addWidget(button, int(name) / kColumns, int(name) % kColumns);
    }
    return box;
}

void LightPanel::layOut() {
    auto* rows = new QFormLayout;
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addRow(tr("Stren&gth"), &strength_);
    rows->addRow(tr("Si&ze"), &size_);
    rows->addRow(tr("Ambie&nt"), &ambient_);
    rows->addRow(tr("M&oves with"), &follows_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 4, 10, 8);
    column->setSpacing(6);
    column->addWidget(rigButtons());
    column->addWidget(&sky_);
    column->addWidget(&sphere_);
    column->addWidget(&place_);
    column->addLayout(rows);
    column->addWidget(&model_);
    column->addWidget(&expert_);
    column->addWidget(&table_);
    column->addStretch(1);
}

void LightPanel::connectParts() {
    connect(&rigs_, &QButtonGroup::idClicked, this, [this](int id) { chooseRig(NamedRig(id)); });
    connect(&sky_, &SkyRow::skyChosen, this, &LightPanel::skyChosen);
    connect(&sky_, &SkyRow::environmentEdited, this, [this](const Environment& environment, bool moving) {
        apply({lighting_.rig, environment}, moving);
    });
    connect(&sphere_, &LightSphere::currentChanged, this, &LightPanel::showLamp);
    connect(&sphere_, &LightSphere::lampMoved, this, &LightPanel::moveLamp);
    connect(&sphere_, &LightSphere::allTurned, this, &LightPanel::turnAll);
    for (const auto& [slider, slide] :
         {std::pair(&strength_, &LightPanel::slideStrength), std::pair(&size_, &LightPanel::slideSize),
          std::pair(&ambient_, &LightPanel::slideAmbient)}) {
        connect(slider, &QSlider::valueChanged, this, slide);
        connect(slider, &QSlider::sliderReleased, this, slide);
    }
    connect(&follows_, &QComboBox::activated, this, &LightPanel::tie);
    connect(&table_, &PanelTable::panelsEdited, this, [this](const std::vector<RigPanel>& panels) {
        apply({{panels, lighting_.rig.follows}, lighting_.environment}, false);
    });
    connect(&expert_, &QToolButton::toggled, this, [this](bool open) {
        expert_.setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        table_.setVisible(open);
    });
}

void LightPanel::setLighting(const Lighting& lighting, const Camera& camera) {
    if (lighting == lighting_ && camera == camera_)
        return;
    if (lighting != lighting_)
        sphere_.letGo();
    lighting_ = lighting;
    camera_ = camera;
    showLighting();
}

void LightPanel::showLighting() {
    const auto named = nameOf(tiedTo(lighting_.rig, LightRig::Follows::camera, camera_));
    // Check the button of the rig
    rigs_.setExclusive(false);  // so that no button may be checked
    for (QAbstractButton* button : rigs_.buttons())
        button->setChecked(named && rigs_.id(button) == int(*named));
    rigs_.setExclusive(true);
    // Show the lamps as the viewer sees them
    lamps_ = lampsOf(lighting_.rig);
    const dmat3 inView =
        glm::transpose(rigAxes(LightRig::Follows::camera, camera_)) * rigAxes(lighting_.rig.follows, camera_);
    std::vector<SphereLamp> shown;
    for (const Lamp& lamp : lamps_)
        shown.push_back({QString::fromStdString(lamp.name), inView * lamp.from, lamp.irradiance, lamp.colour});
    sphere_.setLamps(shown);
    // Show environment and numbers
    sky_.setEnvironment(lighting_.environment);
    const QSignalBlocker silent(&ambient_);
    ambient_.setValue(stepOf(luminanceOf(lighting_.environment.radiance)));
    follows_.setCurrentIndex(int(lighting_.rig.follows));
    table_.setPanels(lighting_.rig.panels);
    showLamp();
}

const Lamp* LightPanel::lamp() const {
    return sphere_.current() < 0 ? nullptr : &lamps_[std::size_t(sphere_.current())];
}

void LightPanel::showLamp() {
    const QSignalBlocker strength(&strength_), size(&size_);
    strength_.setEnabled(lamp());
    size_.setEnabled(lamp());
    place_.setText(lamp() ? lampText(sphere_.lamp(), camera_) : QString());
    if (!lamp())
        return;
    strength_.setValue(stepOf(lamp()->irradiance));
    size_.setValue(stepOf(lamp()->edge));
}

void LightPanel::apply(const Lighting& lighting, bool moving) {
    lighting_ = lighting;
    showLighting();
    emit lightingEdited(lighting_, moving);
}

/// Chooses a rig, placed relative to the view, whatever the lamps turn with afterwards.
void LightPanel::chooseRig(NamedRig name) {
    Lighting lighting = lighting_;
    lighting.rig.follows = LightRig::Follows::camera;
    lighting = litBy(lighting, name);
    lighting.rig = tiedTo(lighting.rig, lighting_.rig.follows, camera_);
    sphere_.setCurrent(0);
    apply(lighting, false);
}

void LightPanel::moveLamp(int index, dvec3 from, bool moving) {
    const dmat3 toRig =
        glm::transpose(rigAxes(lighting_.rig.follows, camera_)) * rigAxes(LightRig::Follows::camera, camera_);
    const std::string name = lamps_[std::size_t(index)].name;
    apply({withLampFrom(lighting_.rig, name, toRig * from), lighting_.environment}, moving);
}

void LightPanel::turnAll(dvec2 drag, bool moving) {
    apply(turned(lighting_, drag, camera_), moving);
}

void LightPanel::slideStrength() {
    apply({withLampStrength(lighting_.rig, lamp()->name, valueAt(strength_, true)), lighting_.environment},
          strength_.isSliderDown());
}

void LightPanel::slideSize() {
    apply({withLampEdge(lighting_.rig, lamp()->name, valueAt(size_, false)), lighting_.environment},
          size_.isSliderDown());
}

void LightPanel::slideAmbient() {
    apply({lighting_.rig, withRadiance(lighting_.environment, valueAt(ambient_, true))}, ambient_.isSliderDown());
}

void LightPanel::tie(int index) {
    apply({tiedTo(lighting_.rig, LightRig::Follows(index), camera_), lighting_.environment}, false);
}

}  // namespace pdr::ui
