#pragma once
/// A tool that measures drags; the receiver of its signals decides what they do.

#include "ui/view/view_tool.h"

namespace pdr::ui {

class DragTool : public ViewTool {
    Q_OBJECT

  public:
    /// `tremble`: movement that still counts as a click [px].
    explicit DragTool(double tremble) : tremble_(tremble) {}

    void press(const ViewPointer& pointer) override;
    void move(const ViewPointer& pointer) override;
    void release(const ViewPointer& pointer) override;

  signals:
    /// Reports a drag: its distance from the press, `total`, and from the last report, `step`, in fractions of the
    /// view's height. `moving`: the drag goes on; the last report comes with false.
    void dragged(QPointF total, QPointF step, bool moving);
    /// Reports a click at `place`, in fractions of the image's width and height. Without an image there is none.
    void clicked(QPointF place);

  private:
    void report(const ViewPointer& pointer, bool moving);

    double tremble_;
    bool dragging_ = false;  ///< the pointer has moved further than a tremble
    QPointF pressed_;        ///< [px]
    QPointF last_;           ///< place of the last report [px]
};

}  // namespace pdr::ui
