#include "ui/tissue/curve_editor.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/text/value_text.h"
#include "ui/tissue/place_step.h"

namespace pdr::ui {
namespace {

constexpr double kZoomPerWheelClick = 1.25, kClosest = 1000;  ///< zoom of the values, and its limit
constexpr double kStep = 0.01;                                ///< step of the arrow keys; part of the visible values
constexpr int kAround = 8;                                    ///< room for points at the edges [px]
constexpr qsizetype kMostDescribed = 20;

QString numberText(double number) {
    return QString::number(number, 'g', 4);
}

}  // namespace

CurveEditor::CurveEditor(QWidget* parent) : PointsPlot(CurveHand::Kind::values, parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(this, &PointsPlot::edited, this, &CurveEditor::describe);
    connect(this, &PointsPlot::selectionChanged, this, &CurveEditor::describe);
    layOut();
    describe();
}

void CurveEditor::setCurve(const Curve& curve, float top, double unit, const QString& unitText) {
    if (top != hand().top() || unitText != unitText_)
        setShownTop(double(top));
    unit_ = unit;
    unitText_ = unitText;
    setPoints(curve, top);
    layOut();
    describe();
}

void CurveEditor::setColours(const std::vector<ColourStop>& stops) {
    colours_ = stops;
    update();
}

void CurveEditor::setHistogram(std::shared_ptr<const Histogram> histogram) {
    histogram_ = std::move(histogram);
    update();
}

void CurveEditor::setBarScale(BarScale scale) {
    barScale_ = scale;
    update();
}

void CurveEditor::setValues(const ValueUnit& values) {
    values_ = values;
    describe();
    update();
}

QMargins CurveEditor::plotMargins() const {
    const int line = fontMetrics().height();
    return {kAround, line + 2, fontMetrics().horizontalAdvance("0.05") + kAround, line + 4};
}

void CurveEditor::layOut() {
    setArea(QRectF(rect().marginsRemoved(plotMargins())));
}

void CurveEditor::resizeEvent(QResizeEvent*) {
    layOut();
}

QString CurveEditor::pointText(const CurvePoint& point) const {
    const QString value = numberText(double(point.value) * unit_);
    const QString place = placeText(view(), values_, double(point.hu));
    return unitText_.isEmpty() ? tr("%1: %2").arg(place, value) : tr("%1: %2 %3").arg(place, value, unitText_);
}

/// Updates the description for screen readers: the selected points, then all points.
void CurveEditor::describe() {
    QStringList lines;
    for (const std::size_t i : selection())
        if (i < points().size() && lines.size() < kMostDescribed)
            lines << tr("selected, %1").arg(pointText(points()[i]));
    lines << tr("%n point(s)", nullptr, int(points().size()));
    for (std::size_t i = 0; i < points().size() && lines.size() < kMostDescribed; ++i)
        lines << pointText(points()[i]);
    setAccessibleDescription(lines.join("; "));
}

CurvePoint CurveEditor::step() const {
    const double hu = std::max(view().rounded(view().huPerPixel()), view().placeStep());
    return {float(hu), float(kStep * view().top())};
}

QString CurveEditor::tipAt(QPointF place) const {
    const double hu = view().hu(place.x());
    QStringList lines{pointText({float(view().rounded(hu)), valueAt(points(), float(hu))})};
    if (histogram_ && histogram_->total() > 0)
        lines << tr("%1 % of the voxels lie below")
                     .arg(numberText(100 * histogram_->count(-1e6, hu) / histogram_->total()));
    lines << tr("Drag points; click the line to add one; wheel zooms, with Shift the values; double click fits");
    return lines.join('\n');
}

void CurveEditor::zoomValues(double clicks) {
    const double top = double(hand().top());
    setShownTop(std::clamp(view().top() / std::pow(kZoomPerWheelClick, clicks), top / kClosest, top));
}

void CurveEditor::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.85);
    painter.setFont(small);
    // Paint bands, histogram and axes
    const QRectF& area = view().area();
    painter.fillRect(area, palette().color(QPalette::Base));
    if (values_.isHu)
        paintTissueBands(painter, view(), palette());
    if (histogram_)
        paintHistogram(painter, view(), histogramBars(*histogram_, view(), barScale_), palette());
    paintAxes(painter, view(), unit_, values_, palette());
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF besideArea(area.right() + kAround, 0, width() - area.right() - kAround, area.top() - 1);
    painter.drawText(besideArea, Qt::AlignLeft | Qt::AlignBottom, unitText_);
    painter.drawText(besideArea.translated(0, area.bottom() + 3), Qt::AlignLeft | Qt::AlignTop, unitName(values_));
    // Paint the curve and its points
    painter.save();
    painter.setClipRect(area.adjusted(-kAround, -kAround, kAround, kAround));
    paintCurve(painter, view(), points(), colours_, palette());
    paintPoints(painter, view(), points(), selection(), palette());
    painter.restore();
    // Paint the rubber band
    if (const auto band = hand().band()) {
        painter.setPen(QPen(palette().color(QPalette::Link), 1, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(*band);
    }
    paintFocus(painter);
}

}  // namespace pdr::ui
