#include "app/jobs/plan_job.h"

#include "app/plan/marks_file.h"
#include "app/plan/scan_fit.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

void PlanJob::save(const Plan& plan, const std::shared_ptr<const Volume>& volume, const QString& file) {
    start([this, plan, volume, file](const Progress&, const std::stop_token&) -> std::function<void()> {
        const auto written = writePlan({markOf(*volume, newSalt()), plan}, ui::fromQt(file));
        if (!written)
            return failure(written.error());
        return [this, plan, file] { emit saved(plan, file); };
    });
}

void PlanJob::exportMarks(const Plan& plan, const std::shared_ptr<const Volume>& volume, const QString& file) {
    start([this, plan, volume, file](const Progress&, const std::stop_token&) -> std::function<void()> {
        const auto written = writeMarks(marksTable(plan, *volume), ui::fromQt(file));
        if (!written)
            return failure(written.error());
        return [this, file] { emit exported(file); };
    });
}

void PlanJob::open(const QString& file, const std::shared_ptr<const Volume>& volume) {
    start([this, file, volume](const Progress&, const std::stop_token&) -> std::function<void()> {
        const auto read = readPlan(ui::fromQt(file));
        if (!read)
            return failure(read.error());
        auto ok = checkIsScanOf(read->scan, *volume);
        if (ok)
            ok = checkPlaces(read->plan, volume->geometry());
        if (!ok)
            return failure(Error{ok.error().what, file.toStdString(), ok.error().hint, ok.error().kind});
        return [this, plan = read->plan, file] { emit opened(plan, file); };
    });
}

}  // namespace pdr::app
