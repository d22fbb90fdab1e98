#pragma once
/// The tool that draws the box whose pixels get their samples first; it also shows that box. Setters emit no signals.

#include <QRectF>
#include <optional>

#include "ui/view/drawing_tool.h"

namespace pdr::ui {

class Viewport;

class RegionBox : public DrawingTool {
    Q_OBJECT

  public:
    /// Adds the tool to the view's tools.
    explicit RegionBox(Viewport* view);

    /// Sets the box in fractions of the image's width and height. None: there is no box.
    void setBox(const std::optional<QRectF>& box);

    void press(const ViewPointer& pointer) override;
    void move(const ViewPointer& pointer) override;
    void release(const ViewPointer& pointer) override;
    void paint(QPainter& painter, const ImagePlace& image) const override;

  signals:
    /// Reports a drawn box in fractions of the image's width and height, clipped to the image. A drag too short for a
    /// box counts as a click.
    void drawn(QRectF box);
    /// Reports that a click or Esc ended drawing without a box.
    void notDrawn();

  private:
    void discard() override { from_.reset(); }
    void reportNothing() override { emit notDrawn(); }
    QRectF dragged(const ImagePlace& image) const;

    std::optional<QRectF> box_;
    std::optional<QPointF> from_;  ///< where the drag began [px]; none: no drag
    QPointF to_;                   ///< [px]
};

}  // namespace pdr::ui
