#pragma once
/// A coordinator's end of one connection, in the thread of the test, which decides when the link sends.

#include "app/coordinator/node_connection.h"
#include "app/coordinator/reference_bits.h"
#include "app/remote/dial.h"
#include "app/remote/listener.h"
#include "render/tiles/reference_tiles.h"
#include "render/tiles/worker_pool.h"

namespace pdr::test {

struct OneLink {
    explicit OneLink(const nodes::ContentKey& key = {std::byte{1}}) : coordinator{pool, key} {
        coordinator.bits = nodes::bitsOf(*referenceTiles(*makeCpuDevice(1)));
        if (!listener.listen({"127.0.0.1", 0}))
            qFatal("no port is free");
        QObject::connect(&listener, &remote::Listener::connected, &listener,
                         [this](remote::Channel* channel) { meet(channel); });
    }
    quint16 port() const { return listener.address().port; }
    void dialNode(quint16 port) {
        dial = std::make_unique<remote::Dial>(remote::Address{"127.0.0.1", port}, kCoordinator);
        QObject::connect(dial.get(), &remote::Dial::connected, &listener,
                         [this](remote::Channel* channel) { meet(channel); });
    }
    void meet(remote::Channel* other) {
        channel = other;
        link = std::make_unique<nodes::NodeConnection>(channel, coordinator);
        QObject::connect(link.get(), &nodes::NodeConnection::joined, &listener, [this] { hasJoined = true; });
        QObject::connect(link.get(), &nodes::NodeConnection::over, &listener,
                         [this](const Text& why) { reason = QString::fromStdString(why); });
    }

    static inline const remote::Identity kCoordinator{remote::Role::coordinator, std::nullopt};
    const std::shared_ptr<WorkerPool> pool = std::make_shared<WorkerPool>(1);
    nodes::Coordinator coordinator;
    remote::Listener listener{kCoordinator};
    std::unique_ptr<remote::Dial> dial;
    remote::Channel* channel = nullptr;  ///< channel of the link
    std::unique_ptr<nodes::NodeConnection> link;
    bool hasJoined = false;
    std::optional<QString> reason;  ///< why the connection is over; none: it is not over
};

}  // namespace pdr::test
