#pragma once
/// A tool that draws on the image once: from startDrawing() on, the mouse does nothing else until drawing ends.

#include "ui/view/view_tool.h"

namespace pdr::ui {

class DrawingTool : public ViewTool {
    Q_OBJECT

  public:
    using ViewTool::ViewTool;

    /// Makes the next drag draw.
    void startDrawing();
    /// Ends drawing and discards what has been drawn.
    void stopDrawing();
    bool isDrawing() const { return drawing_; }

    bool takes(const ViewPointer&) const override { return drawing_; }
    bool hover(const ViewPointer&) override { return drawing_; }
    bool cancel() override;
    std::optional<Qt::CursorShape> cursor() const override;

  private:
    /// Discards what has been drawn.
    virtual void discard() = 0;
    /// Reports that drawing ended without a result.
    virtual void reportNothing() = 0;

    bool drawing_ = false;
};

}  // namespace pdr::ui
