#include "ui/widgets/line_drawing.h"

#include <QTextStream>

namespace pdr::ui {
namespace {

QPointF point(QTextStream& text) {
    double x = 0, y = 0;
    text >> x >> y;
    return {x, y};
}

/// Adds what `letter` stands for. Returns false if that is nothing.
bool add(QPainterPath& path, char letter, QTextStream& text) {
    constexpr double kRound = 1.5;
    const QPointF first = letter == 'Z' ? QPointF() : point(text);
    double radius = 0;
    switch (letter) {
        case 'M':
            path.moveTo(first);
            return true;
        case 'L':
            path.lineTo(first);
            return true;
        case 'C': {
            const QPointF second = point(text);
            path.cubicTo(first, second, point(text));
            return true;
        }
        case 'Z':
            path.closeSubpath();
            return true;
        case 'O':
            text >> radius;
            path.addEllipse(first, radius, radius);
            return true;
        case 'R': {
            const QPointF size = point(text);
            path.addRoundedRect(QRectF(first, QSizeF(size.x(), size.y())), kRound, kRound);
            return true;
        }
        default:
            return false;
    }
}

}  // namespace

QPainterPath drawn(const char* text) {
    QTextStream stream{QByteArray(text)};
    QPainterPath path;
    QString letter;
    while (stream >> letter, !letter.isEmpty() && add(path, letter.at(0).toLatin1(), stream)) {
    }
    return path;
}

}  // namespace pdr::ui
