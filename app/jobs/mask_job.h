#pragma once
/// Computes masks of parts of the body in the background.

#include <memory>

#include "app/jobs/background_job.h"
#include "render/scene/visible.h"
#include "render/segment/body_parts.h"

namespace pdr::app {

class MaskJob : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Computes the mask of what `visible` shows of the scan whose parts are `parts`; ends with made(), refused(),
    /// failed() or cancelled().
    void make(const std::shared_ptr<const pdr::segment::BodyParts>& parts, const pdr::Visible& visible);

  signals:
    void made(const pdr::Visible& visible, const std::shared_ptr<const pdr::Mask>& mask);
    /// Emitted when the parts cannot be told apart in this scan.
    void refused(const pdr::Visible& visible, const pdr::Error& error);
};

}  // namespace pdr::app
