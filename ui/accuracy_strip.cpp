#include "ui/accuracy_strip.h"

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

int indexOf(double levels) {
    const auto step = std::find(kQualitySteps.begin(), kQualitySteps.end(), levels);
    return int(std::min<std::ptrdiff_t>(step - kQualitySteps.begin(), kQualitySteps.size() - 1));
}

}  // namespace

AccuracyStrip::AccuracyStrip(QWidget* parent) : QAbstractSlider(parent) {
    setRange(0, int(kQualitySteps.size()) - 1);
    setSingleStep(1);
    setPageStep(1);
    setValue(maximum());
    setFocusPolicy(Qt::TabFocus);  // a click must not take the keys away from the picture
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Target: how accurate the picture is to become"));
    connect(this, &QAbstractSlider::valueChanged, this, [this] {
        describe();
        emit targetChosen(target());
    });
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
    setValue(indexOf(levels));
    describe();
    update();
}

double AccuracyStrip::target() const {
    return kQualitySteps[std::size_t(value())];
}

/// For those who cannot see the strip.
void AccuracyStrip::describe() {
    const bool known = !accuracy_.steps.empty();
    setAccessibleDescription(known ? stepForecastText(accuracy_.steps[std::size_t(value())], accuracy_.seconds)
                                   : stepText(target()));
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
    for (const QualityStep& step : accuracy_.steps)
        if (step.levels == levels)
            return xOf(step.seconds.value);
    return std::nullopt;
}

/// Where nothing is foretold yet, at the end that has not been reached.
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
    for (const QualityStep& step : accuracy_.steps) {
        const int rank = step.levels == target() ? 2 : &step == next ? 1 : 0;
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
        painter.setBrush(palette().color(QPalette::Highlight));
        painter.drawRect(done);
    }
    const QualityStep* next = nextStep(accuracy_.steps);
    for (const QualityStep& step : accuracy_.steps)
        if (!step.reached && (&step == next || step.levels == target()))
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
    for (std::size_t i = 0; i < places.size(); ++i) {
        painter.drawLine(QPointF(places[i].middle, along.top() - 2), QPointF(places[i].middle, along.bottom() + 2));
        if (places[i].shown)
            painter.drawText(QPointF(places[i].left, height() - fontMetrics().descent() - 1),
                             labelOf(accuracy_.steps[i]));
    }
}

void AccuracyStrip::paintKnob(QPainter& painter) const {
    painter.setPen(QPen(palette().color(hasFocus() ? QPalette::Link : QPalette::Window), 2));
    painter.setBrush(palette().color(QPalette::WindowText));
    painter.drawEllipse(QPointF(knob(), track().center().y()), kKnobRadius - 1, kKnobRadius - 1);
}

/// The step whose tick lies nearest to the mouse is meant, the finest of several at one place.
void AccuracyStrip::choose(double x) {
    if (accuracy_.steps.empty())
        return;
    const auto distance = [&](const QualityStep& step) { return std::fabs(xOf(step.seconds.value) - x); };
    const auto nearest =
        std::min_element(accuracy_.steps.rbegin(), accuracy_.steps.rend(),
                         [&](const QualityStep& a, const QualityStep& b) { return distance(a) < distance(b); });
    setValue(indexOf(nearest->levels));
    update();
}

void AccuracyStrip::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        choose(event->position().x());
}

void AccuracyStrip::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton)
        choose(event->position().x());
}

/// What scrolls past must not change the target.
void AccuracyStrip::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

/// Hovering over the strip tells of all steps, one a line.
bool AccuracyStrip::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QAbstractSlider::event(event);
    QStringList lines{
        tr("Rendering holds at %1: drag the knob, to the left for sooner, to the right for more accurate.")
            .arg(stepText(target()))};
    for (const QualityStep& step : accuracy_.steps)
        lines << stepForecastText(step, accuracy_.seconds);
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), lines.join('\n'), this);
    return true;
}

}  // namespace pdr::ui
