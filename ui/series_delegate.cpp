#include "ui/series_delegate.h"

#include <QApplication>
#include <QPainter>

namespace pdr::ui {
namespace {

constexpr int kPadding = 8;

}  // namespace

void SeriesDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QStyleOptionViewItem ground = option;
    initStyleOption(&ground, index);
    ground.text.clear();
    const QStyle& style = ground.widget ? *ground.widget->style() : *QApplication::style();
    style.drawControl(QStyle::CE_ItemViewItem, &ground, painter, ground.widget);

    const bool loadable = index.data(kLoadableRole).toBool();
    const bool chosen = option.state.testFlag(QStyle::State_Selected);
    QColor colour = option.palette.color(chosen ? QPalette::HighlightedText : QPalette::Text);
    if (!loadable && !chosen)
        colour = option.palette.color(QPalette::PlaceholderText);

    painter->save();
    const QRect area = option.rect.adjusted(kPadding, kPadding, -kPadding, -kPadding);
    const int lineHeight = option.fontMetrics.height() + 2;
    QRect line(area.left(), area.top(), area.width(), lineHeight);
    const auto write = [&](int role, const QFont& font, double opacity) {
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
    write(kFactsRole, option.font, 0.75);
    write(kVerdictRole, option.font, loadable ? 0.75 : 1);
    painter->restore();
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        QStyleOptionFocusRect ring;
        ring.QStyleOption::operator=(option);
        style.drawPrimitive(QStyle::PE_FrameFocusRect, &ring, painter, ground.widget);
    }
}

QSize SeriesDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    return {100, 3 * (option.fontMetrics.height() + 2) + 2 * kPadding};
}

}  // namespace pdr::ui
