#include "ui/view/drawing_tool.h"

namespace pdr::ui {

void DrawingTool::startDrawing() {
    drawing_ = true;
    emit activated();
}

void DrawingTool::stopDrawing() {
    drawing_ = false;
    discard();
    emit changed();
}

bool DrawingTool::cancel() {
    if (!drawing_)
        return false;
    stopDrawing();
    reportNothing();
    return true;
}

std::optional<Qt::CursorShape> DrawingTool::cursor() const {
    return drawing_ ? std::optional(Qt::CrossCursor) : std::nullopt;
}

}  // namespace pdr::ui
