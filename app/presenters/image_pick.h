#pragma once
/// Clicks on the image: finds which place of the patient one shows, lets the user choose where it shows several, and
/// says why where it shows none.

#include "app/jobs/place_job.h"
#include "app/presenters/workspace.h"

namespace pdr::app {

/// A place that a click on the image has found.
struct PickedPlace {
    SeenLayer layer;
    dvec3 direction{0};  ///< unit vector along the ray, away from the viewer, in the patient's axes
    bool free = false;   ///< Alt was held: it is not to be moved to an edge
};

class ImagePick : public QObject {
    Q_OBJECT

  public:
    /// `workspace` and `scenes` must outlive this object.
    ImagePick(const Workspace& workspace, PlaceScenes& scenes);

    /// Finds what the image shows at `place`, in fractions of its width and height. Ends with picked(), a menu that
    /// offers several places, or a sentence.
    void pick(QPointF place);
    /// Gives up, and releases the volume.
    void drop();

  signals:
    void picked(const pdr::app::PickedPlace& place);
    /// Reports that the image shows no place there, or several, of which the user may choose one.
    void unclear();

  private:
    void take(const LayersUnder& under);
    void offer(const LayersUnder& under);

    Workspace workspace_;
    PlaceJob job_;
    bool free_ = false;
};

}  // namespace pdr::app
