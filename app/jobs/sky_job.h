#pragma once
/// Reads an environment image in the background.

#include <memory>

#include "app/jobs/background_job.h"
#include "render/scene/environment_image.h"

namespace pdr::app {

class SkyJob : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Reads an OpenEXR file; ends with found(), failed() or cancelled().
    void read(const QString& file);

  signals:
    /// Reports the environment image, scaled to a mean luminance of 1; see render/scene/sky_image.h.
    void found(const std::shared_ptr<const pdr::EnvironmentImage>& image);
};

}  // namespace pdr::app
