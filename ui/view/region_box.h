#pragma once
/// The box on the picture whose samples come first: a layer over the picture in which it is drawn, and seen
/// afterwards. Setters are silent.

#include <QRectF>
#include <optional>

#include "ui/view/picture_layer.h"

namespace pdr::ui {

class RegionBox : public PictureLayer {
    Q_OBJECT

  public:
    explicit RegionBox(QWidget* picture) : PictureLayer(picture) {}

    /// Fractions of the picture's width and height; none: there is no box.
    void setBox(const std::optional<QRectF>& box);
    /// Of so many pixels, in its view as pictureArea() has it; at first it fills the view.
    void setPicture(QSize size);
    /// The next drag draws a box; until then the mouse does nothing else.
    void startDrawing() { takeMouse(); }
    void stopDrawing();
    bool isDrawing() const { return takesMouse(); }

  signals:
    /// In fractions of the picture's width and height, inside of it; by a drag that is more than a click.
    void drawn(QRectF box);
    /// Nothing was: by a click.
    void notDrawn();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    QRectF dragged() const;
    QRectF area() const;
    QRectF inParts(const QRectF& box) const;
    QRectF inPixels(const QRectF& box) const;

    QSize size_;  ///< of the picture; empty: as the view's
    std::optional<QRectF> box_;
    std::optional<QPointF> from_;  ///< where the drag began [px]; none: it has not
    QPointF to_;
};

}  // namespace pdr::ui
