#pragma once
/// The tool that draws the box whose pixels get their samples first; it also shows that box. Setters emit no signals.

#include <QRectF>
#include <optional>

#include "ui/view/view_tool.h"

namespace pdr::ui {

class Viewport;

class RegionBox : public ViewTool {
    Q_OBJECT

  public:
    /// Adds the tool to the view's tools.
    explicit RegionBox(Viewport* view);

    /// Sets the box in fractions of the image's width and height. None: there is no box.
    void setBox(const std::optional<QRectF>& box);
    /// Makes the next drag draw a box; until then the mouse does nothing else.
    void startDrawing();
    void stopDrawing();
    bool isDrawing() const { return drawing_; }

    bool takes(const ViewPointer&) const override { return drawing_; }
    void press(const ViewPointer& pointer) override;
    void move(const ViewPointer& pointer) override;
    void release(const ViewPointer& pointer) override;
    bool hover(const ViewPointer&) override { return drawing_; }
    bool cancel() override;
    std::optional<Qt::CursorShape> cursor() const override;
    void paint(QPainter& painter, const ImagePlace& image) const override;

  signals:
    /// Reports a drawn box in fractions of the image's width and height, clipped to the image. A drag too short for a
    /// box counts as a click.
    void drawn(QRectF box);
    /// Reports that a click or Esc ended drawing without a box.
    void notDrawn();

  private:
    QRectF dragged(const ImagePlace& image) const;

    bool drawing_ = false;
    std::optional<QRectF> box_;
    std::optional<QPointF> from_;  ///< where the drag began [px]; none: no drag
    QPointF to_;                   ///< [px]
};

}  // namespace pdr::ui
