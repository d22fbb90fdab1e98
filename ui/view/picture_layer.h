#pragma once
/// What is drawn over a picture, all of it, and follows its size. The mouse reaches the picture below unless the layer
/// asks for it.

#include <QColor>
#include <QPainter>
#include <QPolygonF>
#include <QWidget>

namespace pdr::ui {

/// Of lines and marks over a picture: seen on dark ground and on bright bone.
inline constexpr QRgb kMarkColour = qRgb(255, 205, 110);

class PictureLayer : public QWidget {
  public:
    explicit PictureLayer(QWidget* picture);

  protected:
    /// Every press goes here, whose cursor is a cross.
    void takeMouse();
    void leaveMouse();
    bool takesMouse() const { return !testAttribute(Qt::WA_TransparentForMouseEvents); }
    /// Draws a closed line of that width [px] with a dark edge.
    static void drawMark(QPainter& painter, const QPolygonF& line, double width);
    /// Hears of all that happens to the picture.
    bool eventFilter(QObject* picture, QEvent* event) override;
};

}  // namespace pdr::ui
