#include "app/jobs/autosave_job.h"

#include <chrono>
#include <utility>

namespace pdr::app {

using namespace std::chrono_literals;

AutosaveJob::AutosaveJob(std::filesystem::path folder) : file_(std::make_shared<KeptPlan>(std::move(folder))) {
    for (QTimer* timer : {&quiet_, &latest_}) {
        timer->setSingleShot(true);
        connect(timer, &QTimer::timeout, this, &AutosaveJob::keepNow);
    }
    quiet_.setInterval(1s);
    latest_.setInterval(5s);
}

void AutosaveJob::keepSoon(const Plan& plan, const std::shared_ptr<const Volume>& volume) {
    plan_ = plan;
    volume_ = volume;
    quiet_.start();
    if (!latest_.isActive())
        latest_.start();
}

void AutosaveJob::keepNow() {
    quiet_.stop();
    latest_.stop();
    if (!volume_)
        return;
    holds_ = true;
    start([this, file = file_, plan = plan_, volume = std::exchange(volume_, nullptr)](
              const Progress&, const std::stop_token&) -> std::function<void()> {
        if (const auto ok = file->keep(plan, volume); !ok)
            return failure(ok.error());
        return [this] { emit kept(); };
    });
}

void AutosaveJob::discard() {
    releaseVolume();
    if (!std::exchange(holds_, false))
        return;
    start([file = file_](const Progress&, const std::stop_token&) {
        file->discard();
        return [] {};
    });
}

void AutosaveJob::releaseVolume() {
    quiet_.stop();
    latest_.stop();
    volume_.reset();
}

}  // namespace pdr::app
