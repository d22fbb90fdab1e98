#pragma once
/// The tool that picks a place of the image: while it is active, the left button does nothing else. Esc and other tools
/// that become active make it inactive.

#include "ui/view/view_tool.h"

namespace pdr::ui {

class PickTool : public ViewTool {
    Q_OBJECT

  public:
    bool isActive() const { return active_; }
    void setActive(bool active);

    bool takes(const ViewPointer& pointer) const override { return active_ && pointer.button == Qt::LeftButton; }
    void release(const ViewPointer& pointer) override;
    bool cancel() override;
    void stepBack() override { setActive(false); }
    std::optional<Qt::CursorShape> cursor() const override;

  signals:
    /// Reports a pick at `place`, in fractions of the image's width and height, after which the tool is inactive.
    void picked(QPointF place);
    void activeChanged(bool active);

  private:
    bool active_ = false;
};

}  // namespace pdr::ui
