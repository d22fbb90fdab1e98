#pragma once
/// A picture of any size, made beside the session on a device of its own. Both share the processor, so that the session
/// has about half of it; a session that holds gives it all. Render nodes work for the picture until it is done.

#include "app/jobs/background_job.h"
#include "render/accuracy/stop_rule.h"
#include "render/film/display.h"
#include "render/scene/scene.h"
#include "render/session/session.h"
#include "ui/annotation/annotations.h"

namespace pdr::app {

/// What is to be made. Of another shape than the view's it shows more or less at the sides: the camera's angle is that
/// of the height.
struct PictureTask {
    Scene scene;  ///< its film has the size
    Display display;
    std::optional<ui::Annotations> annotations;  ///< of the scene; none: its pixels alone
    StopRule stop;                               ///< when it is good enough
    QString file;                                ///< ".png" or ".exr"
    DeviceOpener device;                         ///< called on the job's thread
};

class PictureJob : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Ends with saved(), failed() or cancelled(); the file appears whole or not at all. While one is made, another
    /// fails at once.
    void make(const pdr::app::PictureTask& task);

  signals:
    void saved(const QString& file);
};

}  // namespace pdr::app
