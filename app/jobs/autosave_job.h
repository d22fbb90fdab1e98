#pragma once
/// Keeps the plan on the disk while the user works, so that no more than six seconds of work are lost if the program
/// ends without notice.

#include <QTimer>
#include <filesystem>
#include <memory>

#include "app/jobs/background_job.h"
#include "app/plan/recovery.h"

namespace pdr::app {

class AutosaveJob : public BackgroundJob {
    Q_OBJECT

  public:
    /// `folder` holds the plans of all runs.
    explicit AutosaveJob(std::filesystem::path folder);

    /// Keeps `plan`, made on `volume`, a second after the last call, and at most five seconds after the first. Ends
    /// with kept() or failed().
    void keepSoon(const Plan& plan, const std::shared_ptr<const Volume>& volume);
    /// Keeps the plan that waits, if one does, at once.
    void keepNow();
    /// Discards what was kept and what waits: nothing would be lost.
    void discard();
    /// Releases the volume. What was kept stays.
    void releaseVolume();

  signals:
    void kept();

  private:
    QTimer quiet_, latest_;                 ///< since the last edit, and since the first one that is not kept
    Plan plan_;                             ///< to be kept when one of them ends
    std::shared_ptr<const Volume> volume_;  ///< null: nothing waits
    std::shared_ptr<KeptPlan> file_;        ///< used on the job's thread alone
    bool holds_ = false;                    ///< whether file_ may hold a plan
};

}  // namespace pdr::app
