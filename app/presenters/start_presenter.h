#pragma once
/// The start screen's recent plans, and plans that are dropped on the window. A plan is opened with the folder of the
/// scan on which it was saved. Plans are remembered only if folders are.

#include "app/presenters/presenter.h"

namespace pdr::app {

class PlanPresenter;
class SeriesPresenter;

class StartPresenter : public Presenter {
    Q_OBJECT

  public:
    StartPresenter(const Workspace& workspace, SeriesPresenter& series, PlanPresenter& plans);

    void showDocument(Changes changes) override;

  private:
    void keep(const QString& file);
    void openWithScan(const QString& file);
    void openDropped(const QString& file);
    void showRecent();

    SeriesPresenter& series_;
    PlanPresenter& plans_;
    QString folder_;   ///< folder that was scanned last
    QString awaited_;  ///< plan to open once its scan is; empty: none
};

}  // namespace pdr::app
