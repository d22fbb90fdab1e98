#pragma once
/// The looks: gallery with small images, brightness, and the user's own looks.

#include "app/jobs/look_images.h"
#include "app/looks/own_looks.h"
#include "app/presenters/presenter.h"
#include "app/rendering/after_first_image.h"
#include "ui/looks/look_panel.h"
#include "ui/looks/visible_row.h"

namespace pdr::app {

class LooksPresenter : public Presenter {
    Q_OBJECT

  public:
    /// `ownLooks`: the folder of the user's own looks.
    LooksPresenter(const Workspace& workspace, const QString& ownLooks);

    void showDocument(Changes changes) override;
    void showFrame(const std::shared_ptr<const Frame>& frame) override;
    void releaseVolume() override;
    /// The panel of the looks, for the presenter of the CT's noise.
    ui::LookPanel& panel() { return *panel_; }
    /// The row below the looks, for the presenter of the visible parts.
    ui::VisibleRow& visibleRow() { return *visible_; }
    LookImages& images() { return images_; }

  private:
    void connectPanel();
    void connectMenu();
    void offerOwnLooks();
    void requestImages(bool moving);
    void save(const QString& name);
    void rename(const QString& from, const QString& to);
    void importFrom(const QString& file);
    void exportTo(const QString& file);
    void keep(const NamedLook& look);
    void showChange(const Result<void>& changed, const std::string& name);

    ui::LookPanel* panel_;
    ui::VisibleRow* visible_;
    OwnLooks own_;
    LookImages images_;
    AfterFirstImage afterImage_;
};

}  // namespace pdr::app
