#pragma once
/// The tool that edits the camera by the wheel, which zooms, and by keys: arrows orbit, or pan with Shift; plus and
/// minus zoom.

#include "ui/view/edited_camera.h"
#include "ui/view/view_tool.h"

namespace pdr::ui {

class CameraSteps : public ViewTool {
  public:
    explicit CameraSteps(EditedCamera& camera) : camera_(camera) {}

    bool wheel(const ViewPointer& pointer, double clicks) override;
    bool key(const QKeyEvent& event) override;

  private:
    EditedCamera& camera_;
};

}  // namespace pdr::ui
