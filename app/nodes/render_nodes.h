#pragma once
/// The render nodes of a program that shows or writes pictures: dials those that it is told of, waits for others to
/// dial, and lets all of them take samples for a WorkerPool. Works in a thread of its own; what it is told, it is told
/// at once, and what it tells comes by signals in the thread that made it.

#include <QObject>
#include <QThread>
#include <memory>
#include <optional>

#include "app/nodes/node_status.h"
#include "app/remote/address.h"
#include "render/tiles/worker_pool.h"

namespace pdr::nodes {

class NodeDesk;

class RenderNodes : public QObject {
    Q_OBJECT

  public:
    /// `bits`: what referenceTiles() of the device that the pool helps come to; nodes with others are turned away.
    RenderNodes(std::shared_ptr<WorkerPool> pool, const std::vector<std::byte>& bits, QObject* parent = nullptr);
    /// Says goodbye to all nodes, which wipe what they have, and waits for that a second at most.
    ~RenderNodes() override;

    /// The certificates of the connections that come: a folder (remote/certificates.h); empty: none, and only this
    /// machine can be talked to.
    void setBundle(const QString& folder);
    /// Dials it, now and whenever the connection is lost. Errors: no such address, or no certificates for it.
    Result<NodeId> add(const QString& address);
    void remove(NodeId node);
    void setPaused(NodeId node, bool paused);
    /// Lets nodes dial: "4743", "192.0.2.7:4743". Returns where it listens. Errors: not possible.
    Result<remote::Address> listen(const QString& address);
    void stopListening();

    /// As of the last change.
    const std::vector<NodeStatus>& nodes() const { return nodes_; }

  signals:
    /// nodes() is another one; at most ten times a second.
    void changed();
    // Emitted in the thread of the connections: each receiver hears of it in its own.
    void joined(const pdr::nodes::NodeStatus& node);
    void lost(const pdr::nodes::NodeStatus& node);

  private:
    std::shared_ptr<WorkerPool> pool_;
    QThread thread_;
    NodeDesk* desk_;  ///< lives in thread_
    std::vector<NodeStatus> nodes_;
};

}  // namespace pdr::nodes
