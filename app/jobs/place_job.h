#pragma once
/// Finds in the background which place a point of the image shows, and what hides a place. Holds the volume until
/// drop().

#include <QPointF>
#include <memory>
#include <optional>
#include <vector>

#include "app/jobs/background_job.h"
#include "app/plan/plan.h"
#include "render/prepare/flatten.h"
#include "render/prepare/hidden_by.h"
#include "render/prepare/layers_under.h"
#include "render/scene/scene.h"

namespace pdr::app {

/// Changes of a document after which something else may hide a place.
inline constexpr Changes kHides =
    Changes::series | Changes::camera | Changes::look | Changes::table | Changes::clip | Changes::model | Changes::mask;

class PlaceJob : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Finds what `scene`, which must have a volume, shows at `place`, in fractions of its width and height. Ends with
    /// found().
    void pick(const pdr::Scene& scene, QPointF place);
    /// Finds what hides each of `placesMm`, in the patient (LPS) [mm], in the image of `scene`. Ends with seen().
    void look(const pdr::Scene& scene, const std::vector<pdr::dvec3>& placesMm);
    /// Cancels the running job and releases the volume.
    void drop();

  signals:
    void found(const pdr::LayersUnder& under);
    /// Reports what hides each of `placesMm`; none: it lies at or behind the eye.
    void seen(const std::vector<pdr::dvec3>& placesMm, const std::vector<std::optional<pdr::HiddenBy>>& hiddenBy);

  private:
    template <class Examine>
    void examine(const Scene& scene, Examine examine);

    /// Keeps what the next scene can reuse. Only the job's thread uses it.
    std::shared_ptr<Flattener> flattener_ = std::make_shared<Flattener>();
};

}  // namespace pdr::app
