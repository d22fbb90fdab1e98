#include "app/jobs/ct_noise_job.h"

#include <utility>

#include "render/smooth/non_local_means.h"

namespace pdr::app {

void CtNoiseJob::reduce(const std::shared_ptr<const Volume>& scan) {
    if (isRunning() && scan_.lock() == scan)
        return;
    scan_ = scan;
    start([this, scan](const Progress& progress, const std::stop_token&) -> std::function<void()> {
        auto denoised = ctDenoised(*scan, progress);
        if (!denoised)
            return failure(denoised.error());
        const auto made = std::make_shared<const Volume>(*std::move(denoised));
        return [this, scan, made] { emit this->made(scan, made); };
    });
}

}  // namespace pdr::app
