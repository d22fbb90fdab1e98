#include "ui/accuracy/accuracy_strip.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace pdr::ui {
namespace {

constexpr double kMargin = 9, kTrackHeight = 8, kKnobRadius = 7, kTop = kKnobRadius + 1, kLabelGap = 8;

constexpr double kSnap = 9;  ///< distance to a tick [px] within which its step is chosen

/// Returns the index of the finest step that is not finer than `levels`, or 0 if there is none.
int indexOf(double levels) {
    const auto finer =
        std::find_if(kQualitySteps.begin(), kQualitySteps.end(), [&](double step) { return step < levels; });
    return int(std::max<std::ptrdiff_t>(finer - kQualitySteps.begin() - 1, 0));
}

}  // namespace

AccuracyStrip::AccuracyStrip(QWidget* parent) : QAbstractSlider(parent) {
    setRange(0, int(kQualitySteps.size()) - 1);
    setSingleStep(1);
    setPageStep(1);
    setValue(maximum());
    setFocusPolicy(Qt::TabFocus);  // a click must not take the keyboard focus from the image
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Target accuracy of the image"));
    connect(this, &QAbstractSlider::valueChanged, this, [this] { take(kQualitySteps[std::size_t(value())]); });
    describe();
}

void AccuracyStrip::setAccuracy(const Accuracy& accuracy) {
    accuracy_ = accuracy;
    const bool known = !accuracy_.steps.empty();
    axis_ =
        known ? StripAxis(accuracy_.steps.front().seconds.value, accuracy_.steps.back().seconds.value) : StripAxis();
    describe();
    update();
}

void AccuracyStrip::setTarget(double levels) {
    const QSignalBlocker silent(this);
    target_ = levels;
    setValue(indexOf(levels));
    describe();
    update();
}

void AccuracyStrip::take(double levels) {
    if (levels == target_)
        return;
    setTarget(levels);
    emit targetChosen(levels);
}

/// Returns the forecast steps, and the target if it lies between them.
std::vector<QualityStep> AccuracyStrip::marks() const {
    std::vector<QualityStep> marks = accuracy_.steps;
    const auto place =
        std::find_if(marks.begin(), marks.end(), [&](const auto& step) { return step.levels <= target_; });
    const bool isStep = place != marks.end() && place->levels == target_;
    if (const auto seconds = secondsAt(accuracy_.steps, target_); seconds && !isStep)
        marks.insert(place, {target_, accuracy_.status.displayError <= target_, *seconds});
    return marks;
}

/// Updates the description for screen readers.
void AccuracyStrip::describe() {
    setAccessibleDescription(stepText(target_));
    for (const QualityStep& mark : marks())
        if (mark.levels == target_)
            setAccessibleDescription(stepForecastText(mark, accuracy_.seconds));
}

QSize AccuracyStrip::minimumSizeHint() const {
    return {200, int(std::ceil(kTop + kTrackHeight + 4)) + fontMetrics().height()};
}

QRectF AccuracyStrip::track() const {
    return {kMargin, kTop - kTrackHeight / 2 + 1, width() - 2 * kMargin, kTrackHeight};
}

double AccuracyStrip::xOf(double seconds) const {
    return track().left() + axis_.at(seconds) * track().width();
}

std::optional<double> AccuracyStrip::tickOf(double levels) const {
    for (const QualityStep& mark : marks())
        if (mark.levels == levels)
            return xOf(mark.seconds.value);
    return std::nullopt;
}

/// Returns the position of the knob [px]. Without a forecast it is at the right end, which has not been reached.
double AccuracyStrip::knob() const {
    return tickOf(target()).value_or(track().right());
}

QString AccuracyStrip::labelOf(const QualityStep& step) const {
    if (step.reached)
        return stepText(step.levels);
    const QString left = durationText(step.seconds.value - accuracy_.seconds);
    return (step.atLeast() ? tr("%1 in at least %2") : tr("%1 in %2")).arg(stepText(step.levels), left);
}

std::vector<StripLabel> AccuracyStrip::labels() const {
    std::vector<StripLabel> labels;
    const QualityStep* next = nextStep(accuracy_.steps);
    for (const QualityStep& step : marks()) {
        const int rank = step.levels == target_ ? 2 : next != nullptr && step.levels == next->levels ? 1 : 0;
        labels.push_back({xOf(step.seconds.value), double(fontMetrics().horizontalAdvance(labelOf(step))), rank});
    }
    placeLabels(labels, track().right(), kLabelGap);
    return labels;
}

void AccuracyStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintTrack(painter);
    paintTicks(painter);
    paintKnob(painter);
}

void AccuracyStrip::paintTrack(QPainter& painter) const {
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Mid));
    painter.drawRect(track());
    if (accuracy_.status.samplesPerPixel > 0) {
        QRectF done = track();
        done.setRight(xOf(accuracy_.seconds));
        painter.setBrush(palette().color(QPalette::Link));
        painter.drawRect(done);
    }
    const QualityStep* next = nextStep(accuracy_.steps);
    for (const QualityStep& step : marks())
        if (!step.reached && (step.levels == target_ || (next != nullptr && step.levels == next->levels)))
            paintBand(painter, step);
}

void AccuracyStrip::paintBand(QPainter& painter, const QualityStep& step) const {
    QRectF band = track();
    band.setLeft(std::max(xOf(step.seconds.low), xOf(accuracy_.seconds)));
    band.setRight(xOf(step.seconds.high));
    painter.setBrush(QBrush(palette().color(QPalette::WindowText), Qt::BDiagPattern));
    painter.drawRect(band);
}

void AccuracyStrip::paintTicks(QPainter& painter) const {
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF along = track();
    const std::vector<StripLabel> places = labels();
    const std::vector<QualityStep> steps = marks();
    for (std::size_t i = 0; i < places.size(); ++i) {
        painter.drawLine(QPointF(places[i].middle, along.top() - 2), QPointF(places[i].middle, along.bottom() + 2));
        if (places[i].shown)
            painter.drawText(QPointF(places[i].left, height() - fontMetrics().descent() - 1), labelOf(steps[i]));
    }
}

void AccuracyStrip::paintKnob(QPainter& painter) const {
    painter.setPen(QPen(palette().color(hasFocus() ? QPalette::Link : QPalette::Window), 2));
    painter.setBrush(palette().color(QPalette::WindowText));
    painter.drawEllipse(QPointF(knob(), track().center().y()), kKnobRadius - 1, kKnobRadius - 1);
}

/// Chooses the target at `x` [px]: near a tick its step, the finest if several have the same place; else the error that
/// is reached at that time.
void AccuracyStrip::choose(double x) {
    if (accuracy_.steps.empty())
        return;
    const auto distance = [&](const QualityStep& step) { return std::fabs(xOf(step.seconds.value) - x); };
    const auto nearest =
        std::min_element(accuracy_.steps.rbegin(), accuracy_.steps.rend(),
                         [&](const QualityStep& a, const QualityStep& b) { return distance(a) < distance(b); });
    const double seconds = axis_.secondsAt((x - track().left()) / track().width());
    take(distance(*nearest) <= kSnap ? nearest->levels : nearestTarget(levelsAt(accuracy_.steps, seconds)));
}

/// Moves a target between two steps back to the step before it.
void AccuracyStrip::keyPressEvent(QKeyEvent* event) {
    const double before = kQualitySteps[std::size_t(value())];
    const bool back = event->key() == Qt::Key_Left || event->key() == Qt::Key_Down;
    if (back && target_ < before)
        return take(before);
    QAbstractSlider::keyPressEvent(event);
}

void AccuracyStrip::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        choose(event->position().x());
}

void AccuracyStrip::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton)
        choose(event->position().x());
}

/// Ignores the wheel, so that scrolling over the strip does not change the target.
void AccuracyStrip::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

/// Shows a tool tip with all steps, one per line.
bool AccuracyStrip::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QAbstractSlider::event(event);
    QStringList lines{
        tr("Rendering stops at %1. Drag left to stop sooner, right for a more accurate image.").arg(stepText(target_))};
    for (const QualityStep& step : marks())
        lines << stepForecastText(step, accuracy_.seconds);
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), lines.join('\n'), this);
    return true;
}

}  // namespace pdr::ui
