#pragma once
/// The crosshair of the slices in the image: where it is, what hides it, and moving it by a click on the image.

#include <QTimer>

#include "app/presenters/image_pick.h"
#include "app/presenters/presenter.h"
#include "ui/slices/crosshair_layer.h"
#include "ui/view/pick_tool.h"

namespace pdr::app {

class SlicesPresenter;

class CrosshairPresenter : public Presenter {
    Q_OBJECT

  public:
    /// `slices` are shown once the crosshair is set; the look-ups share `scenes` with others. Both must outlive this
    /// object.
    CrosshairPresenter(const Workspace& workspace, SlicesPresenter& slices, PlaceScenes& scenes);

    void showDocument(Changes changes) override;
    void releaseVolume() override;
    ui::CrosshairLayer& layer() { return layer_; }
    /// The clicks on the image that find a place, while slices are shown.
    const ImagePick& picks() const { return picks_; }
    /// Sets whether a click on the image moves the crosshair while slices are shown; it does at first.
    void setFollowsClicks(bool follows) { followsClicks_ = follows; }
    /// Shows the slices, and moves the crosshair to what is seen at `place`, in fractions of the image's width and
    /// height.
    void moveTo(QPointF place);

  private:
    void addAction();
    void pick(QPointF place);
    void lookAgain();
    void showHidden(const std::vector<dvec3>& placesMm, const std::vector<std::optional<HiddenBy>>& hidden);

    SlicesPresenter& slices_;
    QAction* action_ = nullptr;  ///< makes the next click on the image set the crosshair
    ui::PickTool click_;
    ui::CrosshairLayer layer_;
    ImagePick picks_;
    PlaceJob looks_;
    bool followsClicks_ = true;
    QTimer atRest_;  ///< runs out when nothing has changed for a while
};

}  // namespace pdr::app
