#include "ui/view/mark.h"

#include <QPen>

namespace pdr::ui {

void drawMark(QPainter& painter, const QPolygonF& line, double width) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 170), 3));
    painter.drawPolygon(line);
    painter.setPen(QPen(QColor(kMarkColour), width));
    painter.drawPolygon(line);
}

}  // namespace pdr::ui
