#pragma once
/// How the image is rendered: device, frame rate, and the methods of Exposure Render for comparison.

#include "app/presenters/presenter.h"
#include "ui/rendering/render_panel.h"

namespace pdr::app {

class RenderingPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit RenderingPresenter(const Workspace& workspace);

    void showDocument(Changes changes) override;

  private:
    void offerDevices();

    ui::RenderPanel* panel_;
};

}  // namespace pdr::app
