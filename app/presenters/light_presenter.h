#pragma once
/// The lights: rig, environment image and optical model, on the panel and by drags on the image.

#include "app/document/light_edits.h"
#include "app/jobs/model_trial.h"
#include "app/jobs/sky_job.h"
#include "app/presenters/presenter.h"
#include "ui/light/light_panel.h"
#include "ui/view/drag_tool.h"

namespace pdr::app {

class LightPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit LightPresenter(const Workspace& workspace);

    void showDocument(Changes changes) override;
    void releaseVolume() override { trial_.cancel(); }
    bool cancelJob() override { return cancel(sky_); }
    SkyJob& sky() { return sky_; }
    ModelTrial& trial() { return trial_; }

  private:
    void connectSky();
    void connectModel();
    void chooseModel(Model model);

    ui::LightPanel* panel_;
    ui::DragTool drag_{0};  ///< with Shift and the right button: turns the lights
    LightEdits edits_;
    SkyJob sky_;
    ModelTrial trial_;
};

}  // namespace pdr::app
