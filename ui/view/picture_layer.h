#pragma once
/// A transparent layer that covers the image's widget and follows its size. Mouse events reach the widget below unless
/// the layer takes the mouse.

#include <QColor>
#include <QPainter>
#include <QPolygonF>
#include <QWidget>

namespace pdr::ui {

/// Colour of lines and marks over the image; visible on dark ground and on bright bone.
inline constexpr QRgb kMarkColour = qRgb(255, 205, 110);

class PictureLayer : public QWidget {
  public:
    explicit PictureLayer(QWidget* picture);

  protected:
    /// Takes all mouse events and shows a cross as the cursor.
    void takeMouse();
    void leaveMouse();
    bool takesMouse() const { return !testAttribute(Qt::WA_TransparentForMouseEvents); }
    /// Draws the closed polygon `line`, `width` pixels wide, with a dark edge.
    static void drawMark(QPainter& painter, const QPolygonF& line, double width);
    /// Receives all events of the widget `picture`.
    bool eventFilter(QObject* picture, QEvent* event) override;
};

}  // namespace pdr::ui
