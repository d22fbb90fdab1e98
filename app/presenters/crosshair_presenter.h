#pragma once
/// The crosshair of the slices in the image: where it is, what hides it, and moving it by a click on the image.

#include <QTimer>

#include "app/jobs/place_job.h"
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

  private:
    void pick(QPointF place);
    void moveToLayer(const LayersUnder& under);
    void offer(const LayersUnder& under);
    void lookAgain();
    void showHidden(dvec3 placeMm, const std::optional<HiddenBy>& hiddenBy);

    ui::CrosshairLayer layer_;
    PlaceJob picks_, looks_;
    QTimer atRest_;  ///< runs out when nothing has changed for a while
};

}  // namespace pdr::app
