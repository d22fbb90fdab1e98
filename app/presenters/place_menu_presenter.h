#pragma once
/// The part of the image's context menu about the place under the pointer: what lies there, and what can be done with
/// it.

#include <QMenu>
#include <QPointer>

#include "app/jobs/place_job.h"
#include "app/presenters/presenter.h"

namespace pdr::app {

class CameraPresenter;
class CrosshairPresenter;
class TissuePresenter;

/// The features that the menu offers for a place.
struct PlaceFeatures {
    CrosshairPresenter& crosshair;
    CameraPresenter& camera;
    TissuePresenter& tissue;
};

class PlaceMenuPresenter : public Presenter {
    Q_OBJECT

  public:
    /// `scenes` is shared with other look-ups, and must outlive this object.
    PlaceMenuPresenter(const Workspace& workspace, const PlaceFeatures& features, PlaceScenes& scenes);

    void releaseVolume() override { job_.drop(); }

  private:
    void fill(QMenu* menu, QPointF place);
    void showPlace(const LayersUnder& under);
    QString textOf(const LayersUnder& under) const;

    PlaceFeatures features_;
    PlaceJob job_;
    QPointer<QAction> heading_;  ///< the entry that says what lies there; null: the menu is closed
};

}  // namespace pdr::app
