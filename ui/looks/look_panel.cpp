#include "ui/looks/look_panel.h"

#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>

namespace pdr::ui {
namespace {

constexpr int kStepsPerStop = 10;
constexpr int kStops = 4;

}  // namespace

LookPanel::LookPanel(QWidget* parent) : QWidget(parent), brightness_(Qt::Horizontal) {
    connect(&gallery_, &LookGallery::lookChosen, this, &LookPanel::lookChosen);
    doesNotShow_.setWordWrap(true);
    doesNotShow_.setAlignment(Qt::AlignLeft | Qt::AlignTop);
    doesNotShow_.setMinimumHeight(2 * doesNotShow_.fontMetrics().lineSpacing());  // keeps what is below in place
    doesNotShow_.setAccessibleName(tr("What this look does not show"));

    brightness_.setAccessibleName(tr("Brightness"));
    brightness_.setToolTip(tr("Brighter to the right. It changes what is shown, not what is computed."));
    brightness_.setRange(-kStops * kStepsPerStop, kStops * kStepsPerStop);
    const auto choose = [this] {
        emit brightnessChosen(double(brightness_.value()) / kStepsPerStop, brightness_.isSliderDown());
    };
    connect(&brightness_, &QSlider::valueChanged, this, choose);
    connect(&brightness_, &QSlider::sliderReleased, this, choose);

    ctDenoised_.setText(tr("CT &denoised"));
    ctDenoised_.setAccessibleName(tr("CT denoised"));
    ctDenoised_.setToolTip(
        tr("Shows the CT with less noise than it has. Slices and measurements stay as they are.\n"
           "It takes as much memory again as the voxels of the scan."));
    connect(&ctDenoised_, &QCheckBox::clicked, this, &LookPanel::ctDenoisedChosen);

    pause_.setAccessibleName(tr("Pause"));
    pause_.setToolTip(tr("Pause or continue rendering (Space)"));
    pause_.setCheckable(true);
    connect(&pause_, &QPushButton::clicked, this, &LookPanel::pauseChosen);
    setPaused(false);

    auto* brightnessLabel = new QLabel(tr("&Brightness"));
    brightnessLabel->setBuddy(&brightness_);

    // A click leaves the keyboard focus with the image, so that Space continues to pause; Tab still reaches everything.
    for (QWidget* control : std::initializer_list<QWidget*>{&brightness_, &ctDenoised_, &pause_})
        control->setFocusPolicy(Qt::TabFocus);

    scroll_.setWidget(&gallery_);
    scroll_.setWidgetResizable(true);
    scroll_.setFrameShape(QFrame::NoFrame);
    scroll_.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_.setFocusPolicy(Qt::NoFocus);
    scroll_.setMinimumHeight(LookGallery::kImage + 40);  // a heading and a row of thumbnails
    gallery_.layout()->setAlignment(Qt::AlignTop);
    connect(
        &gallery_, &LookGallery::unfolded, this, [this](QWidget* group) { scroll_.ensureWidgetVisible(group, 0, 0); },
        Qt::QueuedConnection);  // queued, so that the group has been laid out

    // Lay out the panel
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 6, 8, 10);
    column->setSpacing(8);
    column->addWidget(&menu_);
    column->addWidget(&scroll_, 1);
    column->addWidget(&doesNotShow_);
    column->addWidget(brightnessLabel);
    column->addWidget(&brightness_);
    column->addWidget(&ctDenoised_);
    column->addWidget(&pause_);
    gallery_.setNeighbours(&menu_, {&brightness_, &ctDenoised_, &pause_});
}

void LookPanel::setLook(int index) {
    gallery_.setLook(index);
    const bool known = index >= 0 && index < gallery_.looks().size();
    menu_.setLook(known ? gallery_.looks()[index].name : QString(), known && gallery_.looks()[index].own);
}

void LookPanel::setDoesNotShow(const QString& sentence) {
    doesNotShow_.setText(sentence);
}

void LookPanel::setBrightness(double stops) {
    const QSignalBlocker silent(this);
    brightness_.setValue(int(std::lround(stops * kStepsPerStop)));
}

void LookPanel::setCtDenoised(bool denoised, bool offered) {
    ctDenoised_.setChecked(denoised);
    ctDenoised_.setEnabled(offered);
}

void LookPanel::setPaused(bool paused) {
    pause_.setChecked(paused);
    pause_.setText(paused ? tr("Continue") : tr("Pause"));
}

}  // namespace pdr::ui
