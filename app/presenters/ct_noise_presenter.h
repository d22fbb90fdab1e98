#pragma once
/// Whether the image shows the CT with less noise, and the volume that this takes.

#include "app/jobs/ct_noise_job.h"
#include "app/presenters/presenter.h"
#include "app/rendering/after_first_image.h"
#include "ui/looks/look_panel.h"

namespace pdr::app {

class CtNoisePresenter : public Presenter {
    Q_OBJECT

  public:
    /// `panel` must outlive this object.
    CtNoisePresenter(const Workspace& workspace, ui::LookPanel& panel);

    void showDocument(Changes changes) override;
    void showFrame(const std::shared_ptr<const Frame>& frame) override;
    void releaseVolume() override;
    bool cancelJob() override { return cancel(job_); }
    CtNoiseJob& job() { return job_; }

  private:
    ui::LookPanel& panel_;
    CtNoiseJob job_;
    AfterFirstImage afterImage_;
};

}  // namespace pdr::app
