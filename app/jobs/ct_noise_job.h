#pragma once
/// Takes noise off a scan in the background.

#include <memory>

#include "app/jobs/background_job.h"
#include "render/volume/volume.h"

namespace pdr::app {

class CtNoiseJob : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Makes `scan` with less noise; ends with made(), failed() or cancelled(). A job that does so already goes on.
    void reduce(const std::shared_ptr<const pdr::Volume>& scan);

  signals:
    /// Emitted with the scan and what it is with less noise.
    void made(const std::shared_ptr<const pdr::Volume>& scan, const std::shared_ptr<const pdr::Volume>& denoised);

  private:
    std::weak_ptr<const Volume> scan_;  ///< what the newest job works on
};

}  // namespace pdr::app
