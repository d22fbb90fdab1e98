#include "app/node/relay.h"

#include <chrono>
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
    connect(&minute_, &QTimer::timeout, this, &Relay::tellChecks);
    minute_.start(std::chrono::minutes(1));
}

Relay::~Relay() {
    tellChecks();
}

/// Says once what keeps a node from helping, as that it was caught at a wrong result.
void Relay::tellTroubleOf(const std::vector<nodes::NodeStatus>& nodes) {
    for (const nodes::NodeStatus& node : nodes)
        if (told_.record(node))
            emit said(tr("below: %1: %2").arg(node.name, QString::fromStdString(node.reason)));
}

/// Says what was checked since the start, if there is more than it has said.
void Relay::tellChecks() {
    const NodeChecks all = checks();
    // What was found to be wrong before its use is no result.
    const std::uint64_t found = all.results + all.wrong;
    if (found == std::exchange(toldResults_, found))
        return;
    emit said(tr("below: %1 tiles, %2 % of their samples rendered twice; %3 wrong")
                  .arg(all.results)
                  .arg(100 * all.share(), 0, 'f', 1)
                  .arg(all.wrong));
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
