#include "ui/series/series_delegate.h"

#include <QApplication>
#include <QPainter>
#include <QPixmap>
#include <algorithm>

namespace pdr::ui {
namespace {

constexpr int kPadding = 8;
constexpr int kImage = 48;  ///< side of the thumbnail [px]

}  // namespace

void SeriesDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QStyleOptionViewItem ground = option;
    initStyleOption(&ground, index);
    ground.text.clear();
    ground.icon = {};
    const QStyle& style = ground.widget ? *ground.widget->style() : *QApplication::style();
    style.drawControl(QStyle::CE_ItemViewItem, &ground, painter, ground.widget);

    // Choose the text colour
    const bool loadable = index.data(kLoadableRole).toBool();
    const bool chosen = option.state.testFlag(QStyle::State_Selected);
    QColor colour = option.palette.color(chosen ? QPalette::HighlightedText : QPalette::Text);
    if (!loadable && !chosen)
        colour = option.palette.color(QPalette::PlaceholderText);

    // Draw the thumbnail
    painter->save();
    QRect area = option.rect.adjusted(kPadding, kPadding, -kPadding, -kPadding);
    if (const auto image = index.data(Qt::DecorationRole).value<QPixmap>(); !image.isNull()) {
        QRect place(area.topLeft(), image.size().scaled(kImage, kImage, Qt::KeepAspectRatio));
        painter->setRenderHint(QPainter::SmoothPixmapTransform);
        painter->drawPixmap(place, image);
        area.setLeft(area.left() + kImage + kPadding);
    }
    // Draw the lines of text
    const int lineHeight = option.fontMetrics.height() + 2;
    QRect line(area.left(), area.top(), area.width(), lineHeight);
    const auto write = [&](int role, const QFont& font, double opacity) {
        if (index.data(role).toString().isEmpty())
            return;
        QColor ink = colour;
        ink.setAlphaF(float(opacity));
        painter->setPen(ink);
        painter->setFont(font);
        const QString text = QFontMetrics(font).elidedText(index.data(role).toString(), Qt::ElideRight, line.width());
        painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter, text);
        line.translate(0, lineHeight);
    };
    QFont title = option.font;
    title.setBold(loadable);
    write(kTitleRole, title, 1);
    write(kWhoRole, option.font, 1);
    write(kFactsRole, option.font, 0.75);
    write(kVerdictRole, option.font, loadable ? 0.75 : 1);
    painter->restore();
    // Draw the focus ring
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        QStyleOptionFocusRect ring;
        ring.QStyleOption::operator=(option);
        style.drawPrimitive(QStyle::PE_FrameFocusRect, &ring, painter, ground.widget);
    }
}

QSize SeriesDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const int lines = index.data(kWhoRole).toString().isEmpty() ? 3 : 4;
    return {100, std::max(lines * (option.fontMetrics.height() + 2), kImage) + 2 * kPadding};
}

}  // namespace pdr::ui
