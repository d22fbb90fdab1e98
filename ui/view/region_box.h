#pragma once
/// A layer in which the user draws the box whose pixels get their samples first; it also shows that box. Setters emit
/// no signals.

#include <QRectF>
#include <optional>

#include "ui/view/picture_layer.h"

namespace pdr::ui {

class RegionBox : public PictureLayer {
    Q_OBJECT

  public:
    explicit RegionBox(QWidget* picture) : PictureLayer(picture) {}

    /// Sets the box in fractions of the image's width and height. None: there is no box.
    void setBox(const std::optional<QRectF>& box);
    /// Sets the size of the image [pixels], which lies in the view as pictureArea() places it. Initially it fills the
    /// view.
    void setPicture(QSize size);
    /// Makes the next drag draw a box; until then the mouse does nothing else.
    void startDrawing() { takeMouse(); }
    void stopDrawing();
    bool isDrawing() const { return takesMouse(); }

  signals:
    /// Reports a drawn box in fractions of the image's width and height, clipped to the image. A drag too short for a
    /// box counts as a click.
    void drawn(QRectF box);
    /// Reports that a click ended drawing without a box.
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

    QSize size_;  ///< size of the image [pixels]; empty: the view's
    std::optional<QRectF> box_;
    std::optional<QPointF> from_;  ///< where the drag began [px]; none: no drag
    QPointF to_;
};

}  // namespace pdr::ui
