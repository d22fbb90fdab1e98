#include "ui/view/mark.h"

#include <QPen>

namespace pdr::ui {
namespace {

constexpr QRgb kEdgeColour = qRgba(0, 0, 0, 170);

}  // namespace

void drawMarkLine(QPainter& painter, QPointF from, QPointF to, const QPen& pen) {
    drawMarkLine(painter, QPolygonF({from, to}), pen);
}

void drawMarkLine(QPainter& painter, const QPolygonF& line, const QPen& pen) {
    painter.setPen(QPen(QColor::fromRgba(kEdgeColour), pen.widthF() + 2));
    painter.drawPolyline(line);
    painter.setPen(pen);
    painter.drawPolyline(line);
}

void drawMark(QPainter& painter, const QPolygonF& line, double width) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor::fromRgba(kEdgeColour), 3));
    painter.drawPolygon(line);
    painter.setPen(QPen(QColor(kMarkColour), width));
    painter.drawPolygon(line);
}

}  // namespace pdr::ui
