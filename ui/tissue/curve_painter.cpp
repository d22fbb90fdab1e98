#include "ui/tissue/curve_painter.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <QPalette>
#include <algorithm>
#include <array>
#include <cmath>

#include "render/scene/edit/tissue_bands.h"
#include "ui/widgets/screen_colour.h"

namespace pdr::ui {
namespace {

constexpr double kPoint = 4;  ///< radius [px]
constexpr int kGap = 4;
/// Background colours, in the order of kTissueBands.
constexpr std::array<QRgb, kTissueBands.size()> kBandColours{
    qRgb(90, 120, 160), qRgb(120, 150, 190), qRgb(200, 170, 70),  qRgb(70, 140, 190),
    qRgb(190, 90, 80),  qRgb(200, 100, 160), qRgb(200, 190, 160), qRgb(140, 160, 160)};

/// Appends the first, the lowest, the highest and the last of the points in one pixel column.
void appendColumn(QPolygonF& outline, const QPolygonF& column) {
    if (column.size() <= 4) {
        outline += column;
        return;
    }
    const auto [lowest, highest] =
        std::minmax_element(column.begin(), column.end(), [](QPointF a, QPointF b) { return a.y() < b.y(); });
    outline << column.front() << *std::min(lowest, highest) << *std::max(lowest, highest) << column.back();
}

}  // namespace

vec3 albedoAt(const std::vector<ColourStop>& stops, double hu) {
    const auto next = std::upper_bound(stops.begin(), stops.end(), float(hu),
                                       [](float at, const ColourStop& stop) { return at < stop.hu; });
    if (next == stops.begin() || next == stops.end())
        return next == stops.begin() ? stops.front().albedo : stops.back().albedo;
    const ColourStop &a = *std::prev(next), &b = *next;
    return glm::mix(a.albedo, b.albedo, (float(hu) - a.hu) / (b.hu - a.hu));
}

QPolygonF outlineOf(const Curve& curve, const PlotView& view) {
    const QRectF& area = view.area();
    const auto first = std::lower_bound(curve.begin(), curve.end(), float(view.lowHu()),
                                        [](const CurvePoint& point, float hu) { return point.hu < hu; });
    const auto end = std::upper_bound(first, curve.end(), float(view.highHu()),
                                      [](float hu, const CurvePoint& point) { return hu < point.hu; });
    QPolygonF outline{QPointF(area.left(), view.y(double(valueAt(curve, float(view.lowHu())))))}, column;
    for (auto point = first; point != end; ++point) {
        const QPointF place = view.at(double(point->hu), double(point->value));
        if (!column.isEmpty() && std::floor(column.front().x()) != std::floor(place.x())) {
            appendColumn(outline, column);
            column.clear();
        }
        column << place;
    }
    appendColumn(outline, column);
    return outline << QPointF(area.right(), view.y(double(valueAt(curve, float(view.highHu())))));
}

/// Fills the gradient with many intermediate colours instead of the stops alone: colours mix linearly as light, not in
/// the screen's nonlinear values.
QLinearGradient gradientOf(const std::vector<ColourStop>& stops, const PlotView& view) {
    constexpr int kPieces = 256;
    QGradientStops places;
    for (int i = 0; i <= kPieces; ++i) {
        const double fraction = double(i) / kPieces;
        const double hu = view.lowHu() + fraction * (view.highHu() - view.lowHu());
        places << QGradientStop(fraction, screenColour(albedoAt(stops, hu)));
    }
    QLinearGradient gradient(view.area().topLeft(), view.area().topRight());
    gradient.setStops(places);
    return gradient;
}

void paintTissueBands(QPainter& painter, const PlotView& view, const QPalette& palette) {
    const QRectF& area = view.area();
    const int line = painter.fontMetrics().height();
    double free = area.left();  // left end of the room for the next name
    for (std::size_t i = 0; i < kTissueBands.size(); ++i) {
        const TissueBand& band = kTissueBands[i];
        const double left = std::max(view.x(double(band.lowHu)), area.left());
        const double right = std::min(view.x(double(band.highHu)), area.right());
        if (right <= left)
            continue;
        QColor ground(kBandColours[i]);
        ground.setAlpha(52);
        painter.fillRect(QRectF(QPointF(left, area.top()), QPointF(right, area.bottom())), ground);
        const QString name = QCoreApplication::translate("TissueBand", band.name);
        const double width = painter.fontMetrics().horizontalAdvance(name), middle = (left + right) / 2;
        const double at = std::clamp(middle - width / 2, area.left() + 2, std::max(area.right() - width - 2, 0.0));
        if (at < free || right - left < 2)
            continue;
        painter.setPen(palette.color(QPalette::WindowText));
        painter.drawText(QRectF(at, area.top() - line - 2, width + 1, line), Qt::AlignLeft | Qt::AlignVCenter, name);
        free = at + width + kGap;
    }
}

void paintHistogram(QPainter& painter, const PlotView& view, const std::vector<double>& bars, const QPalette& palette) {
    const QRectF& area = view.area();
    QPolygonF outline{area.bottomLeft()};
    for (std::size_t i = 0; i < bars.size(); ++i)
        outline << QPointF(area.left() + double(i) + 0.5, area.bottom() - bars[i] * area.height());
    outline << area.bottomRight();
    painter.setPen(Qt::NoPen);
    QColor faint = palette.color(QPalette::PlaceholderText);
    faint.setAlpha(130);
    painter.setBrush(faint);
    painter.drawPolygon(outline);
}

void paintCurve(QPainter& painter, const PlotView& view, const Curve& curve, const std::vector<ColourStop>& colours,
                const QPalette& palette) {
    QPolygonF outline = outlineOf(curve, view);
    QLinearGradient below = gradientOf(colours, view);
    QGradientStops faint = below.stops();
    for (QGradientStop& stop : faint)
        stop.second.setAlpha(110);
    below.setStops(faint);
    painter.setPen(Qt::NoPen);
    painter.setBrush(below);
    painter.drawPolygon(QPolygonF{view.area().bottomLeft()} + outline + QPolygonF{view.area().bottomRight()});
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette.color(QPalette::WindowText), 1.5));
    painter.drawPolyline(outline);
}

void paintPoints(QPainter& painter, const PlotView& view, const Curve& curve, const CurveSelection& selection,
                 const QPalette& palette) {
    const auto paint = [&](const CurvePoint& point, QColor ring, QColor fill, double radius) {
        painter.setPen(QPen(ring, 1.5));
        painter.setBrush(fill);
        painter.drawEllipse(view.at(double(point.hu), double(point.value)), radius, radius);
    };
    for (const CurvePoint& point : curve)
        if (double(point.hu) >= view.lowHu() && double(point.hu) <= view.highHu())
            paint(point, palette.color(QPalette::Base), palette.color(QPalette::WindowText), kPoint);
    for (const std::size_t i : selection)
        if (i < curve.size() && double(curve[i].hu) >= view.lowHu() && double(curve[i].hu) <= view.highHu())
            paint(curve[i], palette.color(QPalette::WindowText), palette.color(QPalette::Link), kPoint + 1.5);
}

void paintAxes(QPainter& painter, const PlotView& view, double unit, const ValueUnit& values, const QPalette& palette) {
    const QRectF& area = view.area();
    const QFontMetrics metrics = painter.fontMetrics();
    const int line = metrics.height();
    const QLocale locale;
    painter.setPen(palette.color(QPalette::WindowText));
    const int widest = metrics.horizontalAdvance("-10000") + 2 * kGap;
    const int most = std::max(int(area.width()) / widest, 2);
    for (const double value : roundMarks(values.valueOf(view.lowHu()), values.valueOf(view.highHu()), most)) {
        const double x = view.x(values.voxelOf(value)), half = widest / 2.0;
        painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + 3));
        const double left = std::clamp(x - half, area.left() - kGap, area.right() + kGap - 2 * half);
        painter.drawText(QRectF(left, area.bottom() + 3, 2 * half, line), Qt::AlignCenter,
                         locale.toString(value, 'g', 6));
    }
    constexpr int kMostMarks = 6;
    for (const double mark :
         roundMarks(0, view.top() * unit, std::clamp(int(area.height()) / (2 * line), 1, kMostMarks))) {
        const double y = view.y(mark / unit), top = std::max(y - line / 2.0, area.top());
        painter.drawLine(QPointF(area.right(), y), QPointF(area.right() + 3, y));
        painter.drawText(QRectF(area.right() + 5, top, 100, line), Qt::AlignLeft | Qt::AlignVCenter,
                         locale.toString(mark, 'g', 4));
    }
}

}  // namespace pdr::ui
