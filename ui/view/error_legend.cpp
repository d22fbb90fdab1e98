#include "ui/view/error_legend.h"

#include <QCoreApplication>
#include <QFontMetrics>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/view/error_colours.h"

namespace pdr::ui {
namespace {

constexpr int kPadding = 10, kGap = 6;
constexpr double kSmall = 0.9;  ///< font size relative to the painter's
const QColor kGround(20, 21, 23, 215), kText(222, 222, 218);

QString translated(const char* text) {
    return QCoreApplication::translate("errorLegend", text);
}

double placeOf(double levels) {
    return std::log2(levels / kFinestLevels) / std::log2(kCoarsestLevels / kFinestLevels);
}

/// Paints the colour scale with the labels "±1" to "±64" below it.
void paintScale(QPainter& painter, const QRect& bar) {
    for (int x = bar.left(); x <= bar.right(); ++x) {
        const double place = double(x - bar.left()) / (bar.width() - 1);
        painter.fillRect(x, bar.top(), 1, bar.height(),
                         errorColour(kFinestLevels * std::pow(kCoarsestLevels / kFinestLevels, place)));
    }
    const int line = painter.fontMetrics().height();
    for (double levels = kFinestLevels; levels <= kCoarsestLevels; levels *= 2) {
        const int x = bar.left() + int(std::lround(placeOf(levels) * (bar.width() - 1)));
        painter.drawLine(x, bar.bottom() + 1, x, bar.bottom() + 3);
        painter.drawText(QRect(x - 30, bar.bottom() + 4, 60, line), Qt::AlignHCenter | Qt::AlignTop,
                         translated("±%1").arg(levels));
    }
}

}  // namespace

void paintErrorLegend(QPainter& painter, const QRect& area, bool beforeDenoising) {
    QFont small = painter.font();
    small.setPointSizeF(kSmall * small.pointSizeF());
    painter.setFont(small);
    const QFontMetrics metrics = painter.fontMetrics();
    const QString title = translated(beforeDenoising ? "Error map before denoising" : "Error map");
    const QString unit = translated("95 % error per pixel, of 255"), unknown = translated("not known yet");
    const int line = metrics.height(), barHeight = line * 3 / 4, end = metrics.horizontalAdvance("±64") / 2;
    const int width = std::max(metrics.horizontalAdvance(title), metrics.horizontalAdvance(unit));
    const QRect box(area.left(), area.top(), width + 2 * kPadding, 4 * line + barHeight + kGap + 8 + 2 * kPadding);
    // Draw the ground
    painter.setPen(Qt::NoPen);
    painter.setBrush(kGround);
    painter.drawRoundedRect(box, 4, 4);
    // Draw title, scale, unit and the colour of unknown errors
    const QRect inner = box.adjusted(kPadding, kPadding, -kPadding, -kPadding);
    painter.setPen(kText);
    painter.drawText(inner, Qt::AlignLeft | Qt::AlignTop, title);
    paintScale(painter, {inner.left() + end, inner.top() + line + kGap, width - 2 * end, barHeight});
    painter.drawText(inner.adjusted(0, 0, 0, -line), Qt::AlignLeft | Qt::AlignBottom, unit);
    painter.drawText(inner.adjusted(line + kGap, 0, 0, 0), Qt::AlignLeft | Qt::AlignBottom, unknown);
    painter.fillRect(QRect(inner.left(), inner.bottom() - line + (line - barHeight) / 2 + 1, line, barHeight),
                     errorColour(std::numeric_limits<double>::infinity()));
}

}  // namespace pdr::ui
