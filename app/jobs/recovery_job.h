#pragma once
/// Looks in the background for plans that earlier runs have left, and for the one of a scan.

#include <filesystem>
#include <memory>

#include "app/jobs/background_job.h"
#include "app/plan/recovery.h"

namespace pdr::app {

class RecoveryJob : public BackgroundJob {
    Q_OBJECT

  public:
    /// `folder` holds the plans of all runs.
    explicit RecoveryJob(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Reads the plans that earlier runs have left; ends with found(), also if there are none.
    void look();
    /// Looks again, for the newest lost plan that was made on `volume`; ends with matched() if there is one.
    void match(const std::shared_ptr<const Volume>& volume);

  signals:
    void found(const pdr::app::LostPlans& lost);
    void matched(const pdr::app::LostPlan& plan);

  private:
    std::filesystem::path folder_;
};

}  // namespace pdr::app
