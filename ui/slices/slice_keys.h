#pragma once
/// The tool of a slice for wheel and keys: scrolling, zooming, choosing a window, and what else needs no mouse.

#include "ui/view/view_tool.h"

namespace pdr::ui {

class SliceKeys : public ViewTool {
    Q_OBJECT

  public:
    using ViewTool::ViewTool;

    bool wheel(const ViewPointer& pointer, double clicks) override;
    bool key(const QKeyEvent& event) override;

  signals:
    /// Requests the slice `count` further; positive: towards the head, the back or the patient's left.
    void stepped(int count);
    /// Requests a magnification `factor` times as large, with `place` (fractions of the slice) staying where it is.
    void zoomed(double factor, QPointF place);
    /// Requests the crosshair this many voxels further in the slice, to the right and down.
    void nudged(QPoint voxels);
    /// Requests what a click at the crosshair would do.
    void clicked(Qt::KeyboardModifiers modifiers);
    /// Requests the window of the digit `key`.
    void windowChosen(char key);

  private:
    double unused_ = 0;  ///< part of a wheel click that has not scrolled yet: trackpads report small ones
};

}  // namespace pdr::ui
