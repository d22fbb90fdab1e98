#pragma once
/// Saves, opens and exports plans in the background: a scan of a gigabyte takes a second to be recognised.

#include <memory>

#include "app/jobs/background_job.h"
#include "app/plan/plan_file.h"

namespace pdr::app {

class PlanJob : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Writes `plan`, made on `volume`, to `file`; ends with saved() or failed().
    void save(const pdr::app::Plan& plan, const std::shared_ptr<const pdr::Volume>& volume, const QString& file);
    /// Writes the measurements of `plan`, with what they say of `volume`, to a file of another program
    /// (app/plan/marks_file.h); ends with exported() or failed().
    void exportMarks(const pdr::app::Plan& plan, const std::shared_ptr<const pdr::Volume>& volume, const QString& file);
    /// Reads `file`, and checks that `volume` is the scan on which it was made; ends with opened() or failed().
    void open(const QString& file, const std::shared_ptr<const pdr::Volume>& volume);

  signals:
    void saved(const pdr::app::Plan& plan, const QString& file);
    void exported(const QString& file);
    void opened(const pdr::app::Plan& plan, const QString& file);
};

}  // namespace pdr::app
