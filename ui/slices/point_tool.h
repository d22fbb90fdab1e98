#pragma once
/// The tool that points at places of a slice: the left button, pressed or dragged.

#include "ui/view/view_tool.h"

namespace pdr::ui {

class PointTool : public ViewTool {
    Q_OBJECT

  public:
    using ViewTool::ViewTool;

    void press(const ViewPointer& pointer) override { emit pointed(pointer.fractions(), true); }
    void move(const ViewPointer& pointer) override { emit pointed(pointer.fractions(), true); }
    void release(const ViewPointer& pointer) override { emit pointed(pointer.fractions(), false); }

  signals:
    /// Reports a place, in fractions of the slice's width and height. `moving`: the button is held.
    void pointed(QPointF place, bool moving);
};

}  // namespace pdr::ui
