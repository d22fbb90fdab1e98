#pragma once
/// Finds in the background which place a point of the image shows, and what hides a place. Holds the volume until
/// drop().

#include <QPointF>
#include <memory>
#include <optional>

#include "app/jobs/background_job.h"
#include "render/prepare/flatten.h"
#include "render/prepare/hidden_by.h"
#include "render/prepare/layers_under.h"
#include "render/scene/scene.h"

namespace pdr::app {

class PlaceJob : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Finds what `scene`, which must have a volume, shows at `place`, in fractions of its width and height. Ends with
    /// found().
    void pick(const pdr::Scene& scene, QPointF place);
    /// Finds what hides `placeMm`, in the patient (LPS) [mm], in the image of `scene`. Ends with seen().
    void look(const pdr::Scene& scene, pdr::dvec3 placeMm);
    /// Cancels the running job and releases the volume.
    void drop();

  signals:
    void found(const pdr::LayersUnder& under);
    /// `hiddenBy`: none if the place lies at or behind the eye.
    void seen(pdr::dvec3 placeMm, const std::optional<pdr::HiddenBy>& hiddenBy);

  private:
    template <class Examine>
    void examine(const Scene& scene, Examine examine);

    /// Keeps what the next scene can reuse. Only the job's thread uses it.
    std::shared_ptr<Flattener> flattener_ = std::make_shared<Flattener>();
};

}  // namespace pdr::app
