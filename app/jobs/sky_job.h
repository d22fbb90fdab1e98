#pragma once
/// Reading a picture of surroundings beside the window.

#include <memory>

#include "app/jobs/background_job.h"
#include "render/scene/environment_image.h"

namespace pdr::app {

class SkyJob : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Reads an OpenEXR file; ends with found() or failed().
    void read(const QString& file);

  signals:
    /// Scaled to mean one; see render/scene/sky_picture.h.
    void found(const std::shared_ptr<const pdr::EnvironmentImage>& picture);
};

}  // namespace pdr::app
