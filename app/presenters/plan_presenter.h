#pragma once
/// Plans as files: saving what was measured and set, opening it again on the same scan, exporting what was measured,
/// and asking before it is lost.

#include "app/jobs/plan_job.h"
#include "app/presenters/presenter.h"

namespace pdr::app {

class PlanPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit PlanPresenter(const Workspace& workspace);

    void showDocument(Changes changes) override;
    void releaseVolume() override;
    bool cancelJob() override { return cancel(job_); }
    PlanJob& job() { return job_; }
    /// Saves the plan. A file without an ending gets ".plan.json".
    void save(const QString& file);
    /// Writes the measurements to a file that ends in ".csv" or ".mrk.json".
    void exportMarks(const QString& file);
    /// Opens a plan of the scan that is open. One step to undo.
    void open(const QString& file);

  private:
    void askAndSave();
    void askAndOpen();
    void askAndExport();
    void showMeasurements();

    PlanJob job_;
    std::vector<Measurement> safe_;  ///< the measurements as they were saved or opened last
};

}  // namespace pdr::app
