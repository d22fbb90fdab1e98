#pragma once
/// The region of the image that gets its samples first: a box that the user draws.

#include "app/presenters/presenter.h"
#include "ui/view/region_box.h"

namespace pdr::app {

class RegionPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit RegionPresenter(const Workspace& workspace);

    void showDocument(Changes changes) override;

  private:
    void choose(const std::optional<QRectF>& region);
    void drawOrForget(bool draw);

    ui::RegionBox* box_;
    QAction* action_;
};

}  // namespace pdr::app
