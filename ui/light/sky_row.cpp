#include "ui/light/sky_row.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QSignalBlocker>
#include <cmath>

#include "render/scene/sky_image.h"
#include "ui/widgets/file_dialogs.h"

namespace pdr::ui {

SkyRow::SkyRow(QWidget* parent) : QWidget(parent) {
    choose_.setText(tr("Environment image..."));
    choose_.setToolTip(tr("Light from a panorama of a sky or a room: an OpenEXR file, twice as wide as high"));
    choose_.setCheckable(true);
    remove_.setText(tr("Remove image"));
    remove_.setToolTip(tr("Uniform ambient light instead, as bright"));
    turn_.setRange(-180, 180);
    turn_.setPageStep(15);
    turn_.setAccessibleName(tr("Rotation of the environment image"));
    turn_.setToolTip(tr("Rotates the environment image about the patient's axis [degrees]"));
    for (QWidget* control : std::initializer_list<QWidget*>{&choose_, &remove_, &turn_})
        control->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard focus with the image

    auto* form = new QFormLayout(&turnRow_);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Sk&y turned"), &turn_);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    grid->addWidget(&choose_, 0, 0);
    grid->addWidget(&remove_, 0, 1);
    grid->addWidget(&turnRow_, 1, 0, 1, 2);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);

    connect(&choose_, &QPushButton::clicked, this, &SkyRow::ask);
    connect(&remove_, &QPushButton::clicked, this,
            [this] { emit environmentEdited(withoutImage(environment_), false); });
    connect(&turn_, &QSlider::valueChanged, this, &SkyRow::turn);
    connect(&turn_, &QSlider::sliderReleased, this, &SkyRow::turn);
    setEnvironment({});
}

void SkyRow::setEnvironment(const Environment& environment) {
    environment_ = environment;
    const bool there = environment.image != nullptr;
    choose_.setChecked(there);
    remove_.setVisible(there);
    turnRow_.setVisible(there);
    const QSignalBlocker silent(&turn_);
    turn_.setValue(int(std::lround(environment.rotationDegrees)));
}

/// Asks for a file. The button stays checked only while an environment image lights the volume, even if the user
/// cancels.
void SkyRow::ask() {
    choose_.setChecked(environment_.image != nullptr);
    if (const QString file = askForSky(this); !file.isEmpty())
        emit skyChosen(file);
}

void SkyRow::turn() {
    environment_.rotationDegrees = turn_.value();
    emit environmentEdited(environment_, turn_.isSliderDown());
}

}  // namespace pdr::ui
