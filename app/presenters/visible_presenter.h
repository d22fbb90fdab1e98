#pragma once
/// Which part of the patient is visible, and the masks that this takes.

#include "app/jobs/mask_job.h"
#include "app/presenters/presenter.h"
#include "app/rendering/after_first_image.h"
#include "ui/looks/visible_row.h"

namespace pdr::app {

class VisiblePresenter : public Presenter {
    Q_OBJECT

  public:
    /// `row` must outlive this object.
    VisiblePresenter(const Workspace& workspace, ui::VisibleRow& row);

    void showDocument(Changes changes) override;
    void showFrame(const std::shared_ptr<const Frame>& frame) override;
    void releaseVolume() override;
    bool cancelJob() override { return cancel(masks_); }
    MaskJob& masks() { return masks_; }

  private:
    void connectMasks();

    ui::VisibleRow& row_;
    MaskJob masks_;
    AfterFirstImage afterImage_;
};

}  // namespace pdr::app
