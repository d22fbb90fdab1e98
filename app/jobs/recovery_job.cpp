#include "app/jobs/recovery_job.h"

namespace pdr::app {

void RecoveryJob::look() {
    start([this, folder = folder_](const Progress&, const std::stop_token&) -> std::function<void()> {
        return [this, lost = lostPlans(folder)] { emit found(lost); };
    });
}

void RecoveryJob::match(const std::shared_ptr<const Volume>& volume) {
    start([this, folder = folder_, volume](const Progress&, const std::stop_token&) -> std::function<void()> {
        const LostPlans lost = lostPlans(folder);
        if (const LostPlan* plan = lostPlanOf(lost.plans, *volume))
            return [this, plan = *plan] { emit matched(plan); };
        return [] {};
    });
}

}  // namespace pdr::app
