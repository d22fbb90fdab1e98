#pragma once
/// The look of lines and marks over the image.

#include <QColor>
#include <QPainter>
#include <QPolygonF>

namespace pdr::ui {

/// Colour of lines and marks over the image; visible on dark ground and on bright bone.
inline constexpr QRgb kMarkColour = qRgb(255, 205, 110);

/// Draws a straight line with `pen`, with a dark edge.
void drawMarkLine(QPainter& painter, QPointF from, QPointF to, const QPen& pen);
/// Draws lines from point to point with `pen`, with a dark edge.
void drawMarkLine(QPainter& painter, const QPolygonF& line, const QPen& pen);
/// Draws the closed polygon `line`, `width` pixels wide, with a dark edge.
void drawMark(QPainter& painter, const QPolygonF& line, double width);

}  // namespace pdr::ui
