#pragma once
/// The camera panel: viewpoint, lens, focus and background.

#include "app/jobs/tissue_study.h"
#include "app/presenters/presenter.h"
#include "ui/camera/camera_panel.h"
#include "ui/view/pick_tool.h"

namespace pdr::app {

class CameraPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit CameraPresenter(const Workspace& workspace);

    void showDocument(Changes changes) override;
    void releaseVolume() override { study_.setVolume(nullptr); }
    /// Focuses on what is seen at `place`, in fractions of the image's width and height.
    void focusAt(QPointF place);
    TissueStudy& study() { return study_; }

  private:
    void connectFocus();
    void setBackground(const std::optional<QColor>& colour);
    std::optional<QColor> background() const;

    ui::CameraPanel* panel_;
    ui::PickTool pick_;  ///< picks what is to be in focus
    TissueStudy study_;  ///< measures the depth of what was picked
};

}  // namespace pdr::app
