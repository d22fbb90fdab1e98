#pragma once
/// The crosshair of the slices in the image: where it is, what hides it, and moving it by a click on the image.

#include <QTimer>

#include "app/presenters/image_pick.h"
#include "app/presenters/presenter.h"
#include "ui/slices/crosshair_layer.h"

namespace pdr::app {

class CrosshairPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit CrosshairPresenter(const Workspace& workspace);

    void showDocument(Changes changes) override;
    void releaseVolume() override;
    ui::CrosshairLayer& layer() { return layer_; }
    /// The clicks on the image that find a place, while slices are shown.
    const ImagePick& picks() const { return picks_; }

  private:
    void pick(QPointF place);
    void lookAgain();
    void showHidden(const std::vector<dvec3>& placesMm, const std::vector<std::optional<HiddenBy>>& hidden);

    ui::CrosshairLayer layer_;
    ImagePick picks_;
    PlaceJob looks_;
    QTimer atRest_;  ///< runs out when nothing has changed for a while
};

}  // namespace pdr::app
