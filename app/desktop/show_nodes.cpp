#include "app/desktop/show_nodes.h"

namespace pdr::app {

void showNodes(const DesktopParts& parts) {
    ui::NodesPanel& panel = parts.window.nodes();
    panel.setNodes(parts.nodes.rows());
    panel.setSplit(parts.nodes.splitText());
    parts.window.accuracy().plot().setEvents(parts.nodes.events());
}

void showWantedNodes(const DesktopParts& parts) {
    ui::NodesPanel& panel = parts.window.nodes();
    panel.setListening(parts.nodes.port());
    panel.setBundle(parts.nodes.bundle());
    panel.setWantedSplit(parts.nodes.wantedSplit());
}

void wantNodesAgain(const DesktopParts& parts) {
    const QStringList addresses = parts.settings.nodes();
    const std::optional<quint16> port = parts.settings.listenedPort();
    const std::optional<Split> split = parts.settings.nodeSplit();
    parts.nodes.setBundle(parts.settings.certificates());
    parts.nodes.setSplit(split);
    for (const QString& address : addresses)
        parts.nodes.add(address);
    if (port)
        parts.nodes.listen(port);
    showWantedNodes(parts);
}

void keepNodes(const DesktopParts& parts) {
    parts.settings.keepNodes(parts.nodes.addresses());
    parts.settings.keepListenedPort(parts.nodes.port());
    parts.settings.keepCertificates(parts.nodes.bundle());
    parts.settings.keepNodeSplit(parts.nodes.wantedSplit());
}

}  // namespace pdr::app
