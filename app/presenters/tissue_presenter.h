#pragma once
/// The tissue's optical properties: the panel of curves, drags on the image, and picking a tissue with a click.

#include "app/document/tissue_edits.h"
#include "app/jobs/tissue_study.h"
#include "app/presenters/presenter.h"
#include "ui/tissue/tissue_panel.h"

namespace pdr::app {

class TissuePresenter : public Presenter {
    Q_OBJECT

  public:
    explicit TissuePresenter(const Workspace& workspace);

    void showDocument(Changes changes) override;
    void releaseVolume() override;
    TissueStudy& study() { return study_; }

  private:
    void connectPicking();

    ui::TissuePanel* panel_;
    TissueEdits edits_;
    TissueStudy study_;
};

}  // namespace pdr::app
