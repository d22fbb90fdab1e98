#pragma once
/// Qt's Fusion style with visible borders: its own have a contrast of less than 3.

#include <QProxyStyle>
#include <QStyleOptionSlider>

#include "ui/theme/theme.h"

namespace pdr::ui {

class ThemeStyle : public QProxyStyle {
    Q_OBJECT

  public:
    explicit ThemeStyle(const Theme& theme);

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;
    /// Turns off the second, brighter copy that Fusion draws below disabled text.
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override;

  private:
    void drawBox(const QStyleOption& option, QPainter& painter) const;
    void drawEdge(const QStyleOption& option, QPainter& painter) const;
    void drawGroove(const QStyleOptionSlider& option, QPainter& painter, const QWidget* widget) const;

    Theme theme_;
};

}  // namespace pdr::ui
