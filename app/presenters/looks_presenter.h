#pragma once
/// The looks: gallery with small images, brightness, and the user's own looks.

#include "app/jobs/look_pictures.h"
#include "app/looks/own_looks.h"
#include "app/presenters/presenter.h"
#include "ui/looks/look_panel.h"
#include "ui/looks/visible_row.h"

namespace pdr::app {

class LooksPresenter : public Presenter {
    Q_OBJECT

  public:
    /// `ownLooks`: folder of the user's own looks; empty: the one in the user's configuration.
    LooksPresenter(const Workspace& workspace, const QString& ownLooks);

    void showDocument(Changes changes) override;
    void showFrame(const std::shared_ptr<const Frame>& frame) override;
    void releaseVolume() override { pictures_.forget(); }
    /// The row below the looks, for the presenter of the visible parts.
    ui::VisibleRow& visibleRow() { return *visible_; }
    LookPictures& pictures() { return pictures_; }

  private:
    void connectPanel();
    void connectMenu();
    void offerOwnLooks();
    void requestPictures(bool moving);
    void save(const QString& name);
    void rename(const QString& from, const QString& to);
    void importFrom(const QString& file);
    void exportTo(const QString& file);
    void keep(const NamedLook& look);
    void showChange(const Result<void>& changed, const std::string& name);

    ui::LookPanel* panel_;
    ui::VisibleRow* visible_;
    OwnLooks own_;
    LookPictures pictures_;
};

}  // namespace pdr::app
