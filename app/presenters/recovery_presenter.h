#pragma once
/// Recovery: keeps the plan on the disk while the user works, and brings back what a run that ended without notice has
/// left, as soon as its scan is open.

#include <filesystem>

#include "app/jobs/autosave_job.h"
#include "app/jobs/recovery_job.h"
#include "app/presenters/presenter.h"

namespace pdr::app {

class PlanPresenter;

class RecoveryPresenter : public Presenter {
    Q_OBJECT

  public:
    /// `folder` holds the plans of all runs. `plans` saves and opens plan files, and must outlive this object.
    RecoveryPresenter(const Workspace& workspace, PlanPresenter& plans, const std::filesystem::path& folder);
    /// Returns the folder of plans in the user's state.
    static std::filesystem::path usualFolder();

    void showDocument(Changes changes) override;
    void releaseVolume() override;
    AutosaveJob& autosave() { return autosave_; }
    RecoveryJob& recovery() { return recovery_; }

  private:
    void connectAutosave();
    void keep();
    void tellOfLost(const LostPlans& lost);
    void restore(const LostPlan& lost);

    AutosaveJob autosave_;
    RecoveryJob recovery_;
    Plan safe_;                       ///< the plan as the series was opened, or as a file of the user holds it
    std::filesystem::path restored_;  ///< what was restored, until this run has kept it; empty: nothing
    bool told_ = false;               ///< the user has been told that nothing can be kept
};

}  // namespace pdr::app
