#include "app/node/relay.h"

#include <utility>

#include "app/coordinator/new_pool.h"
#include "render/tiles/shared_device.h"

namespace pdr::node {

Relay::Relay(const std::vector<std::byte>& bits) : pool_(nodes::newPool()), nodes_(pool_, bits) {
    using nodes::NodeStatus;
    using nodes::RenderNodes;
    connect(&nodes_, &RenderNodes::joined, this,
            [this](const NodeStatus& node) { emit said(tr("below: %1 is there").arg(node.name)); });
    connect(&nodes_, &RenderNodes::lost, this, [this](const NodeStatus& node) {
        told_.record(node);
        emit said(tr("below: %1 is gone: %2").arg(node.name, QString::fromStdString(node.reason)));
    });
    connect(&nodes_, &RenderNodes::turnedAway, this,
            [this](const QString& peer, const QString& reason) { emit said(peer + ": " + reason); });
    connect(&nodes_, &RenderNodes::seen, this, &Relay::tellTroubleOf);
}

/// Says once what keeps a node from helping, as that it was caught at a wrong result.
void Relay::tellTroubleOf(const std::vector<nodes::NodeStatus>& nodes) {
    for (const nodes::NodeStatus& node : nodes)
        if (told_.record(node))
            emit said(tr("below: %1: %2").arg(node.name, QString::fromStdString(node.reason)));
}

Result<void> Relay::listen(const NodeOptions& options) {
    nodes_.setBundle(options.relayBundle);
    pool_->setChecksAll(options.checksAll);
    const auto address = nodes_.listen(options.relay);
    if (!address)
        return address.error();
    emit said(tr("relays to nodes at %1").arg(address->text()));
    return {};
}

OpenDevice Relay::sharing(OpenDevice own) const {
    return [own = std::move(own), pool = pool_]() -> Result<std::unique_ptr<Device>> {
        Result<std::unique_ptr<Device>> device = own();
        if (!device)
            return device;
        return shareDevice(*std::move(device), pool);
    };
}

}  // namespace pdr::node
