#pragma once
/// Cutting tissue away: handles and pen on the image, panel and menu.

#include "app/document/cut_edits.h"
#include "app/presenters/presenter.h"
#include "ui/cut/cut_tools.h"

namespace pdr::app {

class CutPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit CutPresenter(const Workspace& workspace);

    void showDocument(Changes changes) override;
    ui::CutTools& tools() { return *tools_; }

  private:
    ui::CutTools* tools_;
    CutEdits edits_;
};

}  // namespace pdr::app
