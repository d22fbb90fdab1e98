#pragma once
/// Renders an image of any size to a file, in parallel with the session on a device of its own. Both share the
/// processor: the session gets about half of it, and while the session is stopped, this job gets all of it. Render
/// nodes sample this image until it is done.

#include <functional>

#include "app/jobs/background_job.h"
#include "render/accuracy/stop_rule.h"
#include "render/film/display.h"
#include "render/scene/scene.h"
#include "render/session/session.h"
#include "render/tiles/node_checks.h"
#include "ui/annotation/annotations.h"

namespace pdr::app {

/// An image to render. If its aspect ratio differs from the view's it shows more or less at the sides, since the
/// camera's angle is that of the height.
struct ImageTask {
    Scene scene;  ///< its film sets the size
    Display display;
    std::optional<ui::Annotations> annotations;  ///< annotations of the scene; none: the pixels alone
    StopRule stop;                               ///< when rendering stops
    QString file;                                ///< file name, ".png" or ".exr"
    DeviceOpener device;                         ///< called on the job's thread
    /// Returns what was checked of the samples of render nodes; empty: there are none.
    std::function<NodeChecks()> checks = {};
};

class ImageJob : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Renders the image and saves it; ends with saved(), failed() or cancelled(). The file appears whole or not at
    /// all. While one image is rendered, a request for another fails at once.
    void make(const pdr::app::ImageTask& task);

  signals:
    void saved(const QString& file);
};

}  // namespace pdr::app
