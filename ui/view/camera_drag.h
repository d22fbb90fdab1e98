#pragma once
/// The tool that edits the camera in a drag: orbit, pan or zoom.

#include "ui/view/edited_camera.h"
#include "ui/view/view_tool.h"

namespace pdr::ui {

/// Returns the camera magnified by a vertical drag [fractions of the view's height]; up brings the target closer.
Camera zoomedByDrag(const Camera& camera, dvec2 drag);

class CameraDrag : public ViewTool {
    Q_OBJECT

  public:
    /// Returns the camera after a drag [fractions of the view's height].
    using Edit = Camera (*)(const Camera& camera, dvec2 drag);

    CameraDrag(EditedCamera& camera, Edit edit) : camera_(camera), edit_(edit) {}

    void press(const ViewPointer& pointer) override;
    void move(const ViewPointer& pointer) override;
    void release(const ViewPointer& pointer) override;

  signals:
    /// Reports a click, at `place` in the view [px].
    void clicked(QPointF place);

  private:
    EditedCamera& camera_;
    Edit edit_;
    bool dragging_ = false;  ///< the pointer has moved further than a tremble
    QPointF pressed_;        ///< [px]
    QPointF last_;           ///< place of the last edit [px]
};

}  // namespace pdr::ui
