#pragma once
/// A layer over the image in which the user draws a closed line and chooses what it cuts. It takes the mouse only while
/// it is drawing. Setters emit no signals.

#include <QPolygonF>
#include <QPushButton>
#include <optional>

#include "render/scene/clip.h"
#include "ui/view/picture_layer.h"

namespace pdr::ui {

class FreehandPen : public PictureLayer {
    Q_OBJECT

  public:
    explicit FreehandPen(QWidget* picture);

    /// Sets the camera and the size [pixels] of the image on the screen. Another camera discards the line.
    void setPicture(const Camera& camera, QSize size);
    /// Makes the next drag draw a line. Until the user has chosen what it cuts, the mouse does nothing else.
    void startDrawing() { takeMouse(); }
    void stopDrawing();
    bool isDrawing() const { return takesMouse(); }

  signals:
    void drawn(const pdr::FreehandCut& cut);
    /// Reports the end of drawing: a line was completed, or was none (a click, or a line around nothing).
    void ended();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    void ask(QPoint place);
    void answer(bool keepInside);
    std::vector<PicturePoint> outline() const;

    std::optional<Camera> camera_;
    QSize size_;
    bool pressed_ = false;
    QPolygonF line_;   ///< [px]
    QWidget answers_;  ///< shown where the mouse was released
    QPushButton remove_, keep_;
};

}  // namespace pdr::ui
