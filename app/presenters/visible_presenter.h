#pragma once
/// Which part of the patient is visible, and the masks that this takes.

#include "app/jobs/mask_job.h"
#include "app/presenters/presenter.h"
#include "ui/looks/visible_row.h"

namespace pdr::app {

class VisiblePresenter : public Presenter {
    Q_OBJECT

  public:
    /// `row` must outlive this object.
    VisiblePresenter(const Workspace& workspace, ui::VisibleRow& row);

    void showDocument(Changes changes) override;
    void releaseVolume() override { masks_.cancel(); }
    bool cancelJob() override { return cancel(masks_); }
    MaskJob& masks() { return masks_; }

  private:
    void connectMasks();

    ui::VisibleRow& row_;
    MaskJob masks_;
};

}  // namespace pdr::app
