#pragma once
/// The panel of render nodes, and which of them are requested again at the next start.

#include "app/presenters/desktop_nodes.h"
#include "app/presenters/presenter.h"
#include "ui/nodes/nodes_panel.h"

namespace pdr::app {

class NodesPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit NodesPresenter(const Workspace& workspace);

    DesktopNodes& job() { return job_; }

  signals:
    /// Reports what happened to nodes, for the plot of the error.
    void eventsChanged(const pdr::ui::PlotEvents& events);

  private:
    void requestAgain();
    void showNodes();
    void showRequested();
    void keepRequested();

    ui::NodesPanel* panel_;
    DesktopNodes job_;
};

}  // namespace pdr::app
