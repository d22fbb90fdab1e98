#include "ui/accuracy/error_marks.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace pdr::ui {
namespace {

constexpr double kHalf = 4, kNear = 6;  ///< half a triangle's size; how near the pointer must be to a mark [px]

QString translated(const char* text) {
    return QCoreApplication::translate("errorMarks", text);
}

/// Paints a triangle around `middle`: filled if it points up, hollow if down, so that the two differ without colour.
void paintTriangle(QPainter& painter, QPointF middle, bool up, const QPalette& palette) {
    const double tip = up ? -kHalf : kHalf;
    const QPointF corners[] = {middle + QPointF(0, tip), middle + QPointF(-kHalf, -tip), middle + QPointF(kHalf, -tip)};
    painter.setPen(QPen(palette.color(QPalette::WindowText), 1.2));
    painter.setBrush(up ? palette.color(QPalette::WindowText) : palette.color(QPalette::Window));
    painter.drawPolygon(corners, 3);
}

bool hasKind(const PlotEvents& events, bool joined) {
    return std::ranges::find(events, joined, &PlotEvent::joined) != events.end();
}

}  // namespace

void paintMarks(QPainter& painter, const ErrorAxes& axes, const PlotEvents& events, const QPalette& palette) {
    const QRectF& area = axes.area();
    for (const PlotEvent& event : events) {
        const double x = axes.xOf(event.seconds);
        painter.setPen(QPen(palette.color(QPalette::PlaceholderText), 1, event.joined ? Qt::SolidLine : Qt::DotLine));
        painter.drawLine(QPointF(x, area.bottom() - 2 * kHalf), QPointF(x, area.center().y()));
        paintTriangle(painter, {x, area.bottom() - kHalf - 1}, event.joined, palette);
    }
}

void paintMarkLegend(QPainter& painter, const ErrorAxes& axes, const PlotEvents& events, const QPalette& palette) {
    const QFontMetrics metrics = painter.fontMetrics();
    double right = axes.area().right();
    const double middle = axes.area().top() + metrics.height() / 2.0 + 1;
    for (const bool joined : {false, true}) {
        if (!hasKind(events, joined))
            continue;
        const QString text = joined ? translated("a render node joined") : translated("a render node was lost");
        const double width = metrics.horizontalAdvance(text);
        painter.setPen(palette.color(QPalette::WindowText));
        painter.drawText(QRectF(right - width, middle - metrics.height() / 2.0, width, metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, text);
        paintTriangle(painter, {right - width - 2 * kHalf, middle}, joined, palette);
        right -= width + 6 * kHalf;
    }
}

QString marksAt(QPointF place, const ErrorAxes& axes, const PlotEvents& events) {
    QStringList lines;
    for (const PlotEvent& event : events)
        if (std::fabs(axes.xOf(event.seconds) - place.x()) <= kNear && axes.area().contains(place))
            lines << event.text;
    return lines.join('\n');
}

}  // namespace pdr::ui
