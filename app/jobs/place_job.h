#pragma once
/// Finds in the background which place a point of the image shows, and what hides a place. Each asker has a job of its
/// own, whose newest question is answered; the prepared scene is shared by all.

#include <QPointF>
#include <memory>
#include <optional>
#include <vector>

#include "app/jobs/background_job.h"
#include "app/jobs/place_scenes.h"
#include "app/plan/plan.h"
#include "render/prepare/hidden_by.h"
#include "render/prepare/layers_under.h"
#include "render/scene/scene.h"

namespace pdr::app {

/// Changes of a document after which something else may hide a place.
inline constexpr Changes kHides =
    Changes::series | Changes::camera | Changes::look | Changes::table | Changes::clip | Changes::model | Changes::mask;

class PlaceJob : public BackgroundJob {
    Q_OBJECT

  public:
    /// `scenes` is shared with other jobs; it must outlive this object.
    explicit PlaceJob(PlaceScenes& scenes) : scenes_(scenes) {}

  public slots:
    /// Finds what `scene`, which must have a volume, shows at `place`, in fractions of its width and height. Ends with
    /// found().
    void pick(const pdr::Scene& scene, QPointF place);
    /// Finds what hides each of `placesMm`, in the patient (LPS) [mm], in the image of `scene`. Ends with seen().
    void look(const pdr::Scene& scene, const std::vector<pdr::dvec3>& placesMm);
    /// Cancels the running job and releases the volume, also that of the other jobs.
    void drop();

  signals:
    void found(const pdr::LayersUnder& under);
    /// Reports what hides each of `placesMm`; none: it lies at or behind the eye.
    void seen(const std::vector<pdr::dvec3>& placesMm, const std::vector<std::optional<pdr::HiddenBy>>& hiddenBy);

  private:
    template <class Examine>
    void examine(const Scene& scene, Examine examine);

    PlaceScenes& scenes_;
};

}  // namespace pdr::app
