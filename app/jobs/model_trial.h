#pragma once
/// What another model costs and changes, measured beside the window on a small picture of the scene.

#include <QObject>

#include "app/jobs/background_job.h"
#include "render/film/display.h"
#include "render/scene/scene.h"

namespace pdr::app {

class ModelTrial : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Compares `scene`, which has a volume, with the same under the model `before`. Ends with measured(), or without a
    /// word where it cannot be known.
    void measure(const pdr::Scene& scene, pdr::Model before, const pdr::Display& display);

  signals:
    /// `model`: the scene's. `timeFactor`: so many times as long does a sample take; `levels`: 95 % of the picture
    /// changes by no more, of 255.
    void measured(pdr::Model model, pdr::Model before, double timeFactor, double levels);
};

}  // namespace pdr::app
