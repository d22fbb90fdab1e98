#pragma once
/// Plans that outlive a program that ends without notice. Each run keeps its plan in a file of its own, a plan file,
/// beside a file that it holds locked. A plan beside which nothing is locked was left behind by a run that has ended.

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/plan/plan_file.h"
#include "render/base/file_lock.h"

namespace pdr::app {

/// The plan of this run. Not safe to use from several threads at once.
class KeptPlan {
  public:
    /// `folder` is made with the first plan, for its owner alone.
    explicit KeptPlan(std::filesystem::path folder);
    KeptPlan(const KeptPlan&) = delete;
    /// Discards the plan: the program has not ended without notice.
    ~KeptPlan();

    /// Keeps `plan`, made on `volume`, in place of the one kept before. Once this has returned, the plan is safe on the
    /// disk. The first plan of a volume takes the time to hash its voxels.
    Result<void> keep(const Plan& plan, const std::shared_ptr<const Volume>& volume);
    void discard();

  private:
    Result<void> begin();

    std::filesystem::path folder_, name_;  ///< the files' folder, and their path without an ending
    std::optional<FileLock> lock_;         ///< none until the first plan
    ScanMark mark_;
    std::weak_ptr<const Volume> marked_;  ///< the volume of mark_
};

/// A plan that a run has left behind.
struct LostPlan {
    std::filesystem::path file;
    SavedPlan saved;
    std::chrono::system_clock::time_point keptAt;
};

struct LostPlans {
    std::vector<LostPlan> plans;  ///< newest first
    std::vector<Error> problems;  ///< one for each file that cannot be read
};

/// Age from which plans that nobody wanted back are removed.
inline constexpr std::chrono::days kLostPlansStay{90};

/// Returns the plans that earlier runs have left in `folder`. Those older than kLostPlansStay are removed.
LostPlans lostPlans(const std::filesystem::path& folder);

/// Removes a plan that is not lost any more, or not wanted.
void removeLost(const std::filesystem::path& file);

/// Returns the newest of `plans` that was made on `volume`; null if none was. Takes the time to hash the voxels for
/// each plan made on a scan of that size.
const LostPlan* lostPlanOf(const std::vector<LostPlan>& plans, const Volume& volume);

}  // namespace pdr::app
