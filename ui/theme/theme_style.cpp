#include "ui/theme/theme_style.h"

#include <QPainter>
#include <QStyleOption>

namespace pdr::ui {
namespace {

constexpr double kRound = 2.5;

void drawRing(QPainter& painter, const QRectF& area, const QColor& colour, double width) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour, width));
    const double inside = width / 2;
    painter.drawRoundedRect(area.adjusted(inside, inside, -inside, -inside), kRound, kRound);
    painter.restore();
}

}  // namespace

ThemeStyle::ThemeStyle(const Theme& theme) : QProxyStyle("Fusion"), theme_(theme) {}

void ThemeStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const {
    switch (element) {
        case PE_IndicatorCheckBox:
            return drawBox(*option, *painter);
        case PE_FrameFocusRect:
            return drawRing(*painter, option->rect, theme_.focus, 2);
        case PE_FrameLineEdit:
            return drawEdge(*option, *painter);
        default:
            return QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
}

void ThemeStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                    const QWidget* widget) const {
    if (const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option); slider && control == CC_Slider)
        return drawGroove(*slider, *painter, widget);
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control == CC_ComboBox || (control == CC_SpinBox && option->subControls.testFlag(SC_SpinBoxFrame)))
        drawEdge(*option, *painter);
}

/// Draws the frame of lists and fields.
void ThemeStyle::drawEdge(const QStyleOption& option, QPainter& painter) const {
    if (option.state.testFlag(State_HasFocus))
        return drawRing(painter, option.rect, theme_.focus, 2);
    drawRing(painter, option.rect, option.state.testFlag(State_Enabled) ? theme_.border : theme_.faint, 1);
}

void ThemeStyle::drawBox(const QStyleOption& option, QPainter& painter) const {
    const bool enabled = option.state.testFlag(State_Enabled);
    const QRectF box = option.rect;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme_.base);
    painter.drawRoundedRect(box, kRound, kRound);
    drawRing(painter, box, enabled ? theme_.border : theme_.faint, 1);
    if (option.state.testFlag(State_On)) {
        const auto at = [&](double x, double y) { return box.topLeft() + QPointF(x * box.width(), y * box.height()); };
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(enabled ? theme_.text : theme_.disabled, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(QPolygonF{at(0.24, 0.52), at(0.43, 0.72), at(0.77, 0.29)});
    }
    painter.restore();
}

/// Draws a slider, with a handle like Fusion's but with a visible border.
void ThemeStyle::drawGroove(const QStyleOptionSlider& option, QPainter& painter, const QWidget* widget) const {
    constexpr double kHalf = 2;
    const bool enabled = option.state.testFlag(State_Enabled);
    const QRectF groove = subControlRect(CC_Slider, &option, SC_SliderGroove, widget);
    const QRectF handle = subControlRect(CC_Slider, &option, SC_SliderHandle, widget);
    const QPointF middle = groove.center();
    const QRectF line = option.orientation == Qt::Horizontal
                            ? QRectF(groove.left(), middle.y() - kHalf, groove.width(), 2 * kHalf)
                            : QRectF(middle.x() - kHalf, groove.top(), 2 * kHalf, groove.height());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(enabled ? theme_.border : theme_.faint);
    painter.drawRoundedRect(line, kHalf, kHalf);
    const bool focused = option.state.testFlag(State_HasFocus);
    const double radius = std::min(handle.width(), handle.height()) / 2 - 1;
    painter.setBrush(enabled ? theme_.raised : theme_.window);
    painter.setPen(QPen(focused ? theme_.focus : enabled ? theme_.border : theme_.faint, focused ? 3 : 1.5));
    painter.drawEllipse(handle.center(), radius, radius);
    painter.restore();
}

int ThemeStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                          QStyleHintReturn* data) const {
    return hint == SH_EtchDisabledText ? 0 : QProxyStyle::styleHint(hint, option, widget, data);
}

}  // namespace pdr::ui
