#include "app/presenters/plan_presenter.h"

#include <QFileInfo>

#include "ui/widgets/file_dialogs.h"

namespace pdr::app {

PlanPresenter::PlanPresenter(const Workspace& workspace) : Presenter(workspace) {
    const ui::WindowActions& actions = window().menuActions();
    connect(actions.savePlan, &QAction::triggered, this, &PlanPresenter::askAndSave);
    connect(actions.openPlan, &QAction::triggered, this, &PlanPresenter::askAndOpen);
    connect(actions.exportMarks, &QAction::triggered, this, &PlanPresenter::askAndExport);
    showProgressOf(job_);
    connect(&job_, &PlanJob::failed, this, &PlanPresenter::showError);
    connect(&job_, &PlanJob::saved, this, [this](const Plan& plan, const QString& file) {
        safe_ = plan.measurements;
        showMeasurements();
        const bool whole = !plan.image.look.environment.image;
        window().status().showForAWhile((whole ? ui::MainWindow::tr("Plan saved as %1")
                                               : ui::MainWindow::tr("Plan saved as %1, without its environment image"))
                                            .arg(QFileInfo(file).fileName()));
    });
    connect(&job_, &PlanJob::exported, this, [this](const QString& file) {
        const QString name = QFileInfo(file).fileName();
        window().status().showForAWhile(ui::MainWindow::tr("Measurements exported as %1").arg(name));
    });
    connect(&job_, &PlanJob::opened, this, [this](const Plan& plan) {
        safe_ = plan.measurements;
        document().edit(plan);
        showMeasurements();
    });
}

void PlanPresenter::askAndSave() {
    if (const QString file = ui::askWhereToSavePlan(&window()); !file.isEmpty())
        save(file);
}

void PlanPresenter::askAndOpen() {
    if (const QString file = ui::askForPlan(&window()); !file.isEmpty())
        open(file);
}

void PlanPresenter::askAndExport() {
    if (const QString file = ui::askWhereToExportMarks(&window()); !file.isEmpty())
        exportMarks(file);
}

void PlanPresenter::save(const QString& file) {
    const QString name = QFileInfo(file).suffix().isEmpty() ? file + ".plan.json" : file;
    if (document().hasVolume())
        job_.save(document().plan(), document().scan(), name);
}

void PlanPresenter::open(const QString& file) {
    if (document().hasVolume())
        job_.open(file, document().scan());
}

void PlanPresenter::exportMarks(const QString& file) {
    if (document().hasVolume())
        job_.exportMarks(document().plan(), document().seen(), file);
}

void PlanPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series)) {
        safe_.clear();
        window().menuActions().savePlan->setEnabled(document().hasVolume());
        window().menuActions().openPlan->setEnabled(document().hasVolume());
    }
    if (has(changes, Changes::series | Changes::measurements))
        showMeasurements();
}

void PlanPresenter::releaseVolume() {
    job_.cancel();
}

/// Offers measurements for export if there are any, and lets the window ask before those are lost that no file holds.
void PlanPresenter::showMeasurements() {
    const std::vector<Measurement>& measurements = document().plan().measurements;
    const bool any = document().hasVolume() && !measurements.empty();
    window().menuActions().exportMarks->setEnabled(any);
    const bool lost = any && measurements != safe_;
    window().setUnsaved(lost ? ui::MainWindow::tr("Measurements are not saved. Discard them?") : QString());
}

}  // namespace pdr::app
