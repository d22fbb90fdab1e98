#pragma once
/// The view of the volume: turning and moving it, the standard views, the film's size, what the View menu shows or
/// hides of the volume, and undo.

#include "app/presenters/presenter.h"

namespace pdr::app {

class ViewPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit ViewPresenter(const Workspace& workspace);

    void showDocument(Changes changes) override;

  private:
    void connectViews();
    void keepOrFitFilm();
    void fitFilm();
    ivec2 viewSize() const;
};

}  // namespace pdr::app
