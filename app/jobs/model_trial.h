#pragma once
/// Measures in the background what another optical model costs and changes, on a small image of the scene.

#include <QObject>

#include "app/jobs/background_job.h"
#include "render/film/display.h"
#include "render/scene/scene.h"

namespace pdr::app {

class ModelTrial : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Compares `scene`, which must have a volume, with the same scene under the model `before`. Ends with measured(),
    /// or without a signal if the comparison is not possible.
    void measure(const pdr::Scene& scene, pdr::Model before, const pdr::Display& display);

  signals:
    /// `model`: the scene's. `timeFactor`: the time of a sample relative to that under `before`. `levels`: 95 % of the
    /// image changes by no more than this [levels of 255].
    void measured(pdr::Model model, pdr::Model before, double timeFactor, double levels);
};

}  // namespace pdr::app
