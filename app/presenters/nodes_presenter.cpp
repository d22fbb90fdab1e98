#include "app/presenters/nodes_presenter.h"

namespace pdr::app {

NodesPresenter::NodesPresenter(const Workspace& workspace)
    : Presenter(workspace), panel_(new ui::NodesPanel), job_(bridge()) {
    window().addPanel(panel_, {"Nodes", ui::WindowDocks::tr("Render nodes"), Qt::Key_F12, ui::PanelPlace::below});
    connect(panel_, &ui::NodesPanel::bundleRequested, &job_, &DesktopNodes::setBundle);
    connect(panel_, &ui::NodesPanel::listenRequested, &job_, &DesktopNodes::listen);
    connect(panel_, &ui::NodesPanel::addRequested, &job_, &DesktopNodes::add);
    connect(panel_, &ui::NodesPanel::pauseRequested, &job_, &DesktopNodes::setPaused);
    connect(panel_, &ui::NodesPanel::removeRequested, &job_, &DesktopNodes::remove);
    connect(panel_, &ui::NodesPanel::splitRequested, &job_, &DesktopNodes::setSplit);
    connect(panel_, &ui::NodesPanel::checksAllRequested, &job_, &DesktopNodes::setChecksAll);
    connect(&job_, &DesktopNodes::failed, panel_, &ui::NodesPanel::setProblem);
    connect(&job_, &DesktopNodes::changed, this, &NodesPresenter::showNodes);
    connect(&job_, &DesktopNodes::wantedChanged, this, [this] {
        showRequested();
        keepRequested();
    });
    requestAgain();
}

void NodesPresenter::showNodes() {
    panel_->setNodes(job_.rows());
    panel_->setSplit(job_.splitText());
    panel_->setChecks(job_.checksText());
    emit eventsChanged(job_.events());
}

void NodesPresenter::showRequested() {
    panel_->setListening(job_.port());
    panel_->setBundle(job_.bundle());
    panel_->setWantedSplit(job_.wantedSplit());
    panel_->setChecksAll(job_.checksAll());
}

/// Requests the nodes of the last run. All settings are read first, since each request saves them.
void NodesPresenter::requestAgain() {
    const QStringList addresses = settings().nodes();
    const std::optional<quint16> port = settings().listenedPort();
    const std::optional<Split> split = settings().nodeSplit();
    const bool checksAll = settings().nodeChecksAll();
    job_.setBundle(settings().certificates());
    job_.setSplit(split);
    job_.setChecksAll(checksAll);
    for (const QString& address : addresses)
        job_.add(address);
    if (port)
        job_.listen(port);
    showRequested();
}

void NodesPresenter::keepRequested() {
    settings().keepNodes(job_.addresses());
    settings().keepListenedPort(job_.port());
    settings().keepCertificates(job_.bundle());
    settings().keepNodeSplit(job_.wantedSplit());
    settings().keepNodeChecksAll(job_.checksAll());
}

}  // namespace pdr::app
