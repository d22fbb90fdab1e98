#include "ui/rendering/render_panel.h"

#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace pdr::ui {

namespace {

enum { kOurs, kK0, kK1 };  // indices in the list of schedules

}  // namespace

RenderPanel::RenderPanel(QWidget* parent) : QWidget(parent) {
    describeControls();
    // A click leaves the keyboard focus with the image; Tab still reaches everything.
    for (QWidget* control : std::initializer_list<QWidget*>{&device_, &automatic_, &framesPerSecond_, &iterations_,
                                                            &expert_, &schedule_, &filter_, &estimator_})
        control->setFocusPolicy(Qt::TabFocus);
    for (QComboBox* box : {&device_, &schedule_, &estimator_}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(8);
    }

    // Lay out the controls
    auto* rows = new QFormLayout;
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addRow(&device_);  // the whole row: names of GPUs are long
    rows->addRow(&automatic_);
    rows->addRow(tr("Frames &per second"), &framesPerSecond_);
    rows->addRow(tr("&Iterations per frame"), &iterations_);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 8, 10, 10);
    column->setSpacing(8);
    column->addLayout(rows);
    column->addWidget(&expert_);
    column->addWidget(comparison());
    column->addStretch(1);
    enableWhatCounts();
    connectControls();
}

void RenderPanel::describeControls() {
    device_.setAccessibleName(tr("Device"));
    device_.setToolTip(tr("The device that renders. Rendering continues there with the samples taken so far."));
    // Describe the pace of refreshing the image
    automatic_.setText(tr("Automatic"));
    automatic_.setAccessibleName(tr("Automatic"));
    automatic_.setToolTip(
        tr("As many iterations per frame as keep the cost of display negligible, within the frame rate. The result is "
           "the same."));
    automatic_.setChecked(true);
    framesPerSecond_.setAccessibleName(tr("Frame rate"));
    framesPerSecond_.setToolTip(tr("Minimum frames per second, where the device can reach it."));
    framesPerSecond_.setRange(0.1, 60);
    framesPerSecond_.setDecimals(1);
    framesPerSecond_.setValue(10);
    framesPerSecond_.setSuffix(tr(" per second"));
    framesPerSecond_.setKeyboardTracking(false);
    iterations_.setAccessibleName(tr("Iterations per frame"));
    iterations_.setToolTip(
        tr("Iterations computed before the image is updated. More is slightly faster, fewer responds sooner; the "
           "result is the same."));
    iterations_.setRange(1, 1000);
    iterations_.setKeyboardTracking(false);
    // Describe the button that shows the comparison
    expert_.setText(tr("Comparison with Exposure Render"));
    expert_.setAccessibleName(tr("Comparison with Exposure Render"));
    expert_.setToolTip(tr("For comparison only: the ways of the renderer that this one replaces."));
    expert_.setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    expert_.setArrowType(Qt::RightArrow);
    expert_.setCheckable(true);
    expert_.setAutoRaise(true);
}

QWidget* RenderPanel::comparison() {
    schedule_.setAccessibleName(tr("Schedule"));
    schedule_.addItems({tr("Ours"), tr("Exposure Render, K0"), tr("Exposure Render, K1")});
    schedule_.setToolTip(
        tr("How iterations become images. Ours accumulates them and updates the display from time to time. Exposure "
           "Render runs all stages for each iteration; K0 also uploads everything each time, K1 does not. For "
           "comparison only."));
    filter_.setText(tr("Blur each iteration"));
    filter_.setAccessibleName(tr("Blur each iteration"));
    filter_.setToolTip(
        tr("Exposure Render blurs every iteration over 3 x 3 pixels before it counts. That hides noise and never "
           "averages out: the image stays wrong. For comparison only."));
    filter_.setChecked(true);
    estimator_.setAccessibleName(tr("Estimator"));
    estimator_.addItems({tr("Unbiased"), tr("March of 3 voxels (biased)")});
    estimator_.setToolTip(
        tr("How light paths are sampled. Unbiased: the image converges to the exact one. The march steps over 3 voxels "
           "at a time as Exposure Render does and scatters once: the image stays wrong. For comparison only."));

    auto* part = new QWidget;
    auto* rows = new QFormLayout(part);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addRow(tr("Schedule"), &schedule_);
    rows->addRow(&filter_);
    rows->addRow(tr("Estimator"), &estimator_);
    part->hide();
    connect(&expert_, &QToolButton::toggled, part, [this, part](bool open) {
        part->setVisible(open);
        expert_.setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    });
    return part;
}

void RenderPanel::connectControls() {
    connect(&device_, &QComboBox::activated, this, [this] { emit deviceChosen(device_.currentData().toString()); });
    const auto pace = [this] {
        enableWhatCounts();
        emit paceChosen(this->pace());
    };
    connect(&automatic_, &QCheckBox::toggled, this, pace);
    connect(&framesPerSecond_, &QDoubleSpinBox::valueChanged, this, pace);
    connect(&iterations_, &QSpinBox::valueChanged, this, pace);
    const auto schedule = [this] {
        enableWhatCounts();
        emit scheduleChosen(this->schedule());
    };
    connect(&schedule_, &QComboBox::currentIndexChanged, this, schedule);
    connect(&filter_, &QCheckBox::toggled, this, schedule);
    connect(&estimator_, &QComboBox::currentIndexChanged, this,
            [this](int index) { emit estimatorChosen(Estimator(index)); });
}

/// Disables the controls that have no effect at present.
void RenderPanel::enableWhatCounts() {
    framesPerSecond_.setEnabled(automatic_.isChecked());
    iterations_.setEnabled(!automatic_.isChecked());
    filter_.setEnabled(schedule().kind != Schedule::Kind::pd);
}

void RenderPanel::setDevices(const QStringList& names, const QStringList& texts) {
    device_.clear();
    for (int i = 0; i < names.size(); ++i) {
        device_.addItem(texts.value(i), names[i]);
        device_.setItemData(i, texts.value(i), Qt::ToolTipRole);
    }
}

void RenderPanel::setDevice(const QString& name) {
    device_.setCurrentIndex(device_.findData(name));
}

void RenderPanel::setPace(const FrameBudget& pace) {
    const QSignalBlocker silent(this);
    automatic_.setChecked(pace.automatic);
    iterations_.setValue(pace.iterations);
    framesPerSecond_.setValue(pace.framesPerSecond);
    enableWhatCounts();
}

void RenderPanel::setSchedule(const Schedule& schedule) {
    const QSignalBlocker silent(this);
    schedule_.setCurrentIndex(schedule.kind == Schedule::Kind::pd ? kOurs : schedule.redundant ? kK0 : kK1);
    filter_.setChecked(schedule.filter);
    enableWhatCounts();
}

void RenderPanel::setEstimator(Estimator estimator) {
    const QSignalBlocker silent(this);
    estimator_.setCurrentIndex(int(estimator));
}

FrameBudget RenderPanel::pace() const {
    return {automatic_.isChecked(), iterations_.value(), framesPerSecond_.value()};
}

Schedule RenderPanel::schedule() const {
    if (schedule_.currentIndex() <= kOurs)
        return {};
    return {.kind = Schedule::Kind::kroes, .redundant = schedule_.currentIndex() == kK0, .filter = filter_.isChecked()};
}

}  // namespace pdr::ui
