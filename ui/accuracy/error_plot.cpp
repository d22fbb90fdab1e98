#include "ui/accuracy/error_plot.h"

#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QPolygonF>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/accuracy/error_marks.h"
#include "ui/text/language.h"

namespace pdr::ui {
namespace {

constexpr double kSigmas = 1.96;        ///< half a normal distribution's 95 % interval [standard deviations]
constexpr double kPoint = 2, kNow = 4;  ///< radii [px]
constexpr int kGap = 6;

QString momentText(double seconds) {
    return seconds < 1 ? ErrorPlot::tr("%1 s").arg(number(seconds, 1))
                       : durationText(seconds).replace(QLocale().decimalPoint() + "0", "");
}

}  // namespace

ErrorPlot::ErrorPlot(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Error against time"));
    setAccuracy({}, kFinestStep);
}

void ErrorPlot::setAccuracy(const Accuracy& accuracy, double target) {
    accuracy_ = accuracy;
    target_ = target;
    describe();
    update();
}

void ErrorPlot::setEvents(const PlotEvents& events) {
    if (events == events_)
        return;
    events_ = events;
    describe();
    update();
}

/// Updates the description for screen readers.
void ErrorPlot::describe() {
    QStringList lines{tr("target: %1").arg(stepText(target_))};
    for (const QualityStep& step : accuracy_.steps)
        lines << stepForecastText(step, accuracy_.seconds);
    for (const PlotEvent& event : events_)
        lines << event.text;
    setAccessibleDescription(lines.join("; "));
}

bool ErrorPlot::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip || events_.empty())
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), marksAt(help->pos(), axes(), events_), this);
    return true;
}

ErrorAxes ErrorPlot::axes() const {
    const int label = fontMetrics().horizontalAdvance(stepText(64)), line = fontMetrics().height();
    const QRectF area = QRectF(rect()).adjusted(label + 2 * kGap, kGap, -2 * kGap, -line - kGap);
    const double last = accuracy_.steps.empty() ? 0 : accuracy_.steps.back().seconds.value;
    return ErrorAxes(area, accuracy_.points, last);
}

void ErrorPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ErrorAxes axes = this->axes();
    paintGrid(painter, axes);
    painter.save();
    painter.setClipRect(axes.area().adjusted(-kNow, -kNow, kNow, kNow));
    paintTarget(painter, axes);
    if (!accuracy_.points.empty()) {
        paintRootLine(painter, axes);
        paintForecast(painter, axes);
        paintMarks(painter, axes, events_, palette());
        paintMeasured(painter, axes);
        paintMarkLegend(painter, axes, events_, palette());
    }
    painter.restore();
    if (accuracy_.points.empty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(axes.area(), Qt::AlignCenter, tr("The error is not known yet"));
    }
}

void ErrorPlot::paintGrid(QPainter& painter, const ErrorAxes& axes) const {
    const QRectF& area = axes.area();
    const QColor line = palette().color(QPalette::Mid), text = palette().color(QPalette::WindowText);
    const int height = fontMetrics().height();
    const std::vector<double> marks = axes.levels();
    const bool room = double(marks.size() - 1) * height <= area.height();
    // Draw the marks of levels, with every second label where room is short
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const double levels = marks[i], y = axes.yOf(levels);
        painter.setPen(line);
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        if (!room && i % 2 != 0)
            continue;
        painter.setPen(text);
        painter.drawText(QRectF(0, y - height / 2.0, area.left() - kGap, height), Qt::AlignRight | Qt::AlignVCenter,
                         stepText(levels));
    }
    // Draw the marks of time
    for (const double moment : axes.moments()) {
        const double x = axes.xOf(moment);
        painter.setPen(line);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setPen(text);
        const double half = fontMetrics().horizontalAdvance(momentText(moment)) / 2.0 + 1;
        const double left = std::clamp(x - half, 0.0, width() - 2 * half);
        painter.drawText(QRectF(left, area.bottom() + 3, 2 * half, height), Qt::AlignCenter, momentText(moment));
    }
}

void ErrorPlot::paintTarget(QPainter& painter, const ErrorAxes& axes) const {
    const double y = axes.yOf(target_);
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1, Qt::DashLine));
    painter.drawLine(QPointF(axes.area().left(), y), QPointF(axes.area().right(), y));
    const QRectF label(axes.area().left() + kGap, y - fontMetrics().height() - 1, 200, fontMetrics().height());
    painter.drawText(label, Qt::AlignLeft | Qt::AlignBottom, tr("target"));
}

/// Paints the course of independent samples through the newest error.
void ErrorPlot::paintRootLine(QPainter& painter, const ErrorAxes& axes) const {
    const QLineF line = axes.rootLine(accuracy_.points.back());
    painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1, Qt::DotLine));
    painter.drawLine(line);
    const int height = fontMetrics().height();
    const QPointF below(kGap, height / 2.0);  // the line falls
    painter.drawText(QRectF(line.p1() + below, QSizeF(100, height)), Qt::AlignLeft | Qt::AlignTop, tr("1/√t"));
}

void ErrorPlot::paintForecast(QPainter& painter, const ErrorAxes& axes) const {
    const ErrorPoint& now = accuracy_.points.back();
    QPolygonF middle{axes.at(now.seconds, now.levels)}, sooner = middle, later = middle;
    for (const QualityStep& step : accuracy_.steps)
        if (!step.reached) {
            middle << axes.at(step.seconds.value, step.levels);
            sooner << axes.at(step.seconds.low, step.levels);
            later << axes.at(step.seconds.high, step.levels);
        }
    std::reverse(later.begin(), later.end());
    // Hatch the interval
    QColor hatching = palette().color(QPalette::WindowText);
    hatching.setAlpha(110);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QBrush(hatching, Qt::BDiagPattern));
    painter.drawPolygon(sooner + later);
    // Draw the forecast
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Link), 1, Qt::DashLine));
    painter.drawPolyline(middle);
}

void ErrorPlot::paintMeasured(QPainter& painter, const ErrorAxes& axes) const {
    QPolygonF line, above, below;
    for (const ErrorPoint& point : accuracy_.points) {
        const double half = kSigmas * point.spread;
        line << axes.at(point.seconds, point.levels);
        above << axes.at(point.seconds, point.levels + half);
        below.prepend(axes.at(point.seconds, std::max(point.levels - half, 0.01)));
    }
    // Draw the line, its band and the points
    QColor band = palette().color(QPalette::Link);
    painter.setPen(QPen(band, 1.5));
    painter.drawPolyline(line);
    band.setAlpha(90);
    painter.setPen(Qt::NoPen);
    painter.setBrush(band);
    painter.drawPolygon(above + below);
    painter.setBrush(palette().color(QPalette::Link));
    for (const QPointF& point : line)
        painter.drawEllipse(point, kPoint, kPoint);
    // Mark the newest point
    painter.setBrush(palette().color(QPalette::WindowText));
    painter.drawEllipse(line.back(), kNow, kNow);
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF label(line.back() + QPointF(kNow + 4, -fontMetrics().height() - 2),
                       QSizeF(200, fontMetrics().height()));
    painter.drawText(label, Qt::AlignLeft | Qt::AlignVCenter,
                     tr("now, %1").arg(durationText(accuracy_.points.back().seconds)));
}

}  // namespace pdr::ui
