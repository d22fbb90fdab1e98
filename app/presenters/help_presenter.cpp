#include "app/presenters/help_presenter.h"

#include "ui/manual/manual_window.h"

namespace pdr::app {

HelpPresenter::HelpPresenter(const Workspace& workspace) : Presenter(workspace) {
    connect(window().menuActions().manual, &QAction::triggered, this, &HelpPresenter::showManual);
}

/// Opens the manual's window, or brings it to the front. It is made when it is first asked for.
void HelpPresenter::showManual() {
    auto* manual = window().findChild<ui::ManualWindow*>();
    if (!manual)
        manual = new ui::ManualWindow(&window());
    manual->show();
    manual->raise();
    manual->activateWindow();
}

}  // namespace pdr::app
