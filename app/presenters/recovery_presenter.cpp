#include "app/presenters/recovery_presenter.h"

#include <QDateTime>
#include <QLocale>
#include <QStandardPaths>
#include <utility>

#include "app/presenters/plan_presenter.h"
#include "ui/text/to_qt.h"

namespace pdr::app {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Recovery)
};

/// Returns when a plan was kept, with its date unless it was today: "14:32".
QString timeOf(const LostPlan& plan) {
    const auto sinceEpoch = plan.keptAt.time_since_epoch();
    const QDateTime kept =
        QDateTime::fromMSecsSinceEpoch(std::chrono::duration_cast<std::chrono::milliseconds>(sinceEpoch).count());
    if (kept.date() == QDate::currentDate())
        return QLocale().toString(kept.time(), QLocale::ShortFormat);
    return QLocale().toString(kept, QLocale::ShortFormat);
}

QString measurementsOf(const LostPlan& plan) {
    return Texts::tr("%n measurement(s)", nullptr, int(plan.saved.plan.measurements.size()));
}

}  // namespace

RecoveryPresenter::RecoveryPresenter(const Workspace& workspace, PlanPresenter& plans,
                                     const std::filesystem::path& folder)
    : Presenter(workspace), autosave_(folder), recovery_(folder) {
    connectAutosave();
    connect(&recovery_, &RecoveryJob::found, this, &RecoveryPresenter::tellOfLost);
    connect(&recovery_, &RecoveryJob::matched, this, &RecoveryPresenter::restore);
    for (const auto signal : {&PlanJob::saved, &PlanJob::opened})
        connect(&plans.job(), signal, this, [this](const Plan& plan) {
            safe_ = plan;
            keep();
        });
    recovery_.look();
}

void RecoveryPresenter::connectAutosave() {
    connect(&autosave_, &AutosaveJob::kept, this, [this] {
        told_ = false;
        if (!restored_.empty())
            removeLost(std::exchange(restored_, {}));
    });
    connect(&autosave_, &AutosaveJob::failed, this, [this](const Error& error) {
        if (!std::exchange(told_, true))
            showError(
                {error.what, error.where,
                 phrase("Until this is fixed, unsaved work is lost if the program ends unexpectedly: save the plan "
                        "yourself.")});
    });
}

std::filesystem::path RecoveryPresenter::usualFolder() {
    const QString state = qEnvironmentVariable("XDG_STATE_HOME");
    const QString home = QStandardPaths::writableLocation(QStandardPaths::HomeLocation);
    return ui::fromQt((state.startsWith('/') ? state : home + "/.local/state") + "/pd-render/plans");
}

void RecoveryPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series)) {
        safe_ = document().plan();
        restored_.clear();
        autosave_.discard();
        if (document().hasVolume())
            recovery_.match(document().scan());
    }
    keep();
}

/// Keeps the plan, unless nothing would be lost: nothing was edited, a file of the user holds it, or only the slices
/// were moved.
void RecoveryPresenter::keep() {
    if (!document().hasVolume())
        return;
    const Changes edited = changesBetween(safe_, document().plan());
    if (document().canUndo() && has(edited, ~Changes::navigation))
        autosave_.keepSoon(document().plan(), document().scan());
    else
        autosave_.discard();
}

void RecoveryPresenter::releaseVolume() {
    autosave_.releaseVolume();
    recovery_.cancel();
}

void RecoveryPresenter::tellOfLost(const LostPlans& lost) {
    ui::MessageBar& message = window().message();
    for (const Error& problem : lost.problems)
        message.add(QString::fromStdString(problem.text()));
    if (lost.plans.empty() || document().hasVolume())
        return;
    const LostPlan& newest = lost.plans.front();
    if (lost.plans.size() == 1)
        message.add(Texts::tr("A plan from %1 with %2 was not saved. It will be restored when its series is opened.")
                        .arg(timeOf(newest), measurementsOf(newest)));
    else
        message.add(Texts::tr("%1 plans were not saved, the last one from %2 with %3. They will be restored when their "
                              "series are opened.")
                        .arg(lost.plans.size())
                        .arg(timeOf(newest), measurementsOf(newest)));
    message.offer(lost.plans.size() == 1 ? Texts::tr("Delete it") : Texts::tr("Delete them"), [lost] {
        for (const LostPlan& plan : lost.plans)
            removeLost(plan.file);
    });
}

/// Brings back a lost plan of the scan that is open. One step to undo.
void RecoveryPresenter::restore(const LostPlan& lost) {
    restored_ = lost.file;
    document().edit(lost.saved.plan);
    autosave_.keepNow();
    window().message().addAbove(
        Texts::tr("The plan from %1 with %2, which was not saved, has been restored. Undo removes it again.")
            .arg(timeOf(lost), measurementsOf(lost)));
}

}  // namespace pdr::app
