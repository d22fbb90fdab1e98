#pragma once
/// The tool that picks a place of the image: while it is active, the left button does nothing else.

#include "ui/view/view_tool.h"

namespace pdr::ui {

class PickTool : public ViewTool {
    Q_OBJECT

  public:
    void setActive(bool active);

    bool takes(const ViewPointer& pointer) const override { return active_ && pointer.button == Qt::LeftButton; }
    void release(const ViewPointer& pointer) override;
    std::optional<Qt::CursorShape> cursor() const override;

  signals:
    /// Reports a pick at `place`, in fractions of the image's width and height. The tool stays active.
    void picked(QPointF place);

  private:
    bool active_ = false;
};

}  // namespace pdr::ui
