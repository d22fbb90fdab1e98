#pragma once
/// The tissue's optical properties: the panel of curves, drags on the image, and picking a tissue with a click.

#include "app/document/tissue_edits.h"
#include "app/jobs/tissue_study.h"
#include "app/presenters/presenter.h"
#include "app/rendering/after_first_image.h"
#include "ui/tissue/tissue_panel.h"
#include "ui/view/drag_tool.h"
#include "ui/view/pick_tool.h"

namespace pdr::app {

class TissuePresenter : public Presenter {
    Q_OBJECT

  public:
    explicit TissuePresenter(const Workspace& workspace);

    void showDocument(Changes changes) override;
    void showFrame(const std::shared_ptr<const Frame>& frame) override;
    void releaseVolume() override;
    /// Shows the tissue that is seen at `place`, in fractions of the image's width and height.
    void pick(QPointF place);
    TissueStudy& study() { return study_; }
    ui::DragTool& dragTool() { return drag_; }
    ui::PickTool& pickTool() { return pick_; }

  private:
    void connectTools();
    void showVolume();

    ui::TissuePanel* panel_;
    ui::DragTool drag_{ui::kTremble};  ///< with Ctrl: a drag edits the curves, a click picks a tissue
    ui::PickTool pick_;
    TissueEdits edits_;
    TissueStudy study_;
    AfterFirstImage afterImage_;
};

}  // namespace pdr::app
