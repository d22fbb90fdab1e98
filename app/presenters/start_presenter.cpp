#include "app/presenters/start_presenter.h"

#include <utility>

#include "app/presenters/plan_presenter.h"
#include "app/presenters/series_presenter.h"

namespace pdr::app {

StartPresenter::StartPresenter(const Workspace& workspace, SeriesPresenter& series, PlanPresenter& plans)
    : Presenter(workspace), series_(series), plans_(plans) {
    const ui::RecentMenu* recent = window().menuActions().recent;
    connect(recent, &ui::RecentMenu::rememberChosen, this, &StartPresenter::showRecent);
    connect(recent, &ui::RecentMenu::forgetRequested, this, &StartPresenter::showRecent);
    connect(&window().start(), &ui::StartPanel::planChosen, this, &StartPresenter::openWithScan);
    connect(&window(), &ui::MainWindow::planDropped, this, &StartPresenter::openDropped);
    connect(&window(), &ui::MainWindow::folderChosen, this, [this] { awaited_.clear(); });
    connect(&series_.import(), &ImportJob::scanned, this,
            [this](const dicom::ScanResult&, const QString& folder) { folder_ = folder; });
    connect(&series_.import(), &ImportJob::failed, this, [this] { awaited_.clear(); });
    connect(&series_.import(), &ImportJob::cancelled, this, [this] { awaited_.clear(); });
    for (const auto used : {&PlanJob::saved, &PlanJob::opened})
        connect(&plans_.job(), used, this, [this](const Plan&, const QString& file) { keep(file); });
    showRecent();
}

void StartPresenter::keep(const QString& file) {
    settings().keepPlan({file, folder_});
    showRecent();
}

void StartPresenter::showRecent() {
    QStringList files;
    for (const RecentPlan& plan : settings().recentPlans())
        files << plan.file;
    window().start().setRecentPlans(files);
}

/// Opens the folder of the plan's scan, and the plan once the scan is there.
void StartPresenter::openWithScan(const QString& file) {
    for (const RecentPlan& plan : settings().recentPlans())
        if (plan.file == file) {
            series_.open(plan.folder);
            awaited_ = file;
        }
}

void StartPresenter::openDropped(const QString& file) {
    if (document().hasVolume())
        return plans_.open(file);
    showError({phrase("a plan needs its scan"), file.toStdString(),
               phrase("Open the folder of the scan first, then drop the plan again.")});
}

void StartPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series) && document().hasVolume() && !awaited_.isEmpty())
        plans_.open(std::exchange(awaited_, {}));
}

}  // namespace pdr::app
