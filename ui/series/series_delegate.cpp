#include "ui/series/series_delegate.h"

#include <QApplication>
#include <QPainter>
#include <QPixmap>
#include <algorithm>

namespace pdr::ui {
namespace {

constexpr int kPadding = 8;
constexpr int kImage = 56;  ///< side of the square in which the thumbnail lies [px]

int lineHeight(const QStyleOptionViewItem& option) {
    return option.fontMetrics.height() + 2;
}

bool isHeading(const QModelIndex& index) {
    return index.data(kSeriesRole).toInt() < 0;
}

/// Returns the colour of the row's text. Rows that cannot be loaded are quiet, headings are not.
QColor inkOf(const QStyleOptionViewItem& option, const QModelIndex& index) {
    if (option.state.testFlag(QStyle::State_Selected))
        return option.palette.color(QPalette::Active, QPalette::HighlightedText);
    const bool loud = isHeading(index) || index.data(kLoadableRole).toBool();
    return option.palette.color(QPalette::Active, loud ? QPalette::Text : QPalette::PlaceholderText);
}

/// Paints the title, bold unless the series is refused, and the lines below it; what is too long ends in dots.
void paintLines(QPainter& painter, const QRect& area, const QStyleOptionViewItem& option, const QModelIndex& index) {
    QRect line(area.left(), area.top(), area.width(), lineHeight(option));
    const auto write = [&](const QString& text, const QFont& font, double opacity) {
        QColor ink = inkOf(option, index);
        ink.setAlphaF(float(opacity));
        painter.setPen(ink);
        painter.setFont(font);
        painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                         QFontMetrics(font).elidedText(text, Qt::ElideRight, line.width()));
        line.translate(0, line.height());
    };
    const bool loud = isHeading(index) || index.data(kLoadableRole).toBool();
    QFont title = option.font;
    title.setBold(loud);
    write(index.data(kTitleRole).toString(), title, 1);
    for (const QString& text : index.data(kLinesRole).toStringList())
        write(text, option.font, loud ? 0.75 : 1);
}

}  // namespace

void SeriesDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    // Draw the ground
    QStyleOptionViewItem ground = option;
    initStyleOption(&ground, index);
    ground.text.clear();
    ground.icon = {};
    const QStyle& style = ground.widget ? *ground.widget->style() : *QApplication::style();
    if (!isHeading(index))
        style.drawControl(QStyle::CE_ItemViewItem, &ground, painter, ground.widget);

    // Draw the thumbnail and the lines, which begin at one place whether it is there yet or not
    painter->save();
    QRect area = option.rect.adjusted(kPadding, kPadding, -kPadding, -kPadding);
    if (!isHeading(index)) {
        const QRect square(area.topLeft(), QSize(kImage, kImage));
        if (const auto image = index.data(Qt::DecorationRole).value<QPixmap>(); !image.isNull()) {
            QRect place(QPoint(), image.size().scaled(square.size(), Qt::KeepAspectRatio));
            place.moveCenter(square.center());
            painter->setRenderHint(QPainter::SmoothPixmapTransform);
            painter->drawPixmap(place, image);
        }
        area.setLeft(square.right() + 1 + kPadding);
    }
    paintLines(*painter, area, option, index);
    painter->restore();

    // Draw the focus ring
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        QStyleOptionFocusRect ring;
        ring.QStyleOption::operator=(option);
        style.drawPrimitive(QStyle::PE_FrameFocusRect, &ring, painter, ground.widget);
    }
}

QSize SeriesDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const int lines = 1 + int(index.data(kLinesRole).toStringList().size());
    const int least = isHeading(index) ? 0 : kImage;
    return {100, std::max(lines * lineHeight(option), least) + 2 * kPadding};
}

}  // namespace pdr::ui
