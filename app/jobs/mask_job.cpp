#include "app/jobs/mask_job.h"

#include <utility>

#include "render/scene/visible_mask.h"

namespace pdr::app {

void MaskJob::make(const std::shared_ptr<const segment::BodyParts>& parts, const Visible& visible) {
    start([this, parts, visible](const Progress& progress, const std::stop_token&) -> std::function<void()> {
        auto mask = visibleMask(*parts, visible, parts->volume().geometry(), progress);
        if (!mask)
            return [this, visible, error = mask.error()] { emit refused(visible, error); };
        return [this, visible, mask = *std::move(mask)] { emit made(visible, mask); };
    });
}

}  // namespace pdr::app
