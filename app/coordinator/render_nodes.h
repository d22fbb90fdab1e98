#pragma once
/// All render nodes of a coordinator: dials the ones that were added, accepts those that dial, and connects both to a
/// WorkerPool. Runs a network thread of its own. Call it from one thread, which receives changed().

#include <QObject>
#include <QThread>
#include <memory>
#include <optional>

#include "app/coordinator/node_status.h"
#include "app/remote/address.h"
#include "render/tiles/worker_pool.h"

namespace pdr::nodes {

class NodeDesk;

class RenderNodes : public QObject {
    Q_OBJECT

  public:
    /// `bits`: referenceTiles() of the own device; nodes that differ in them are refused.
    RenderNodes(std::shared_ptr<WorkerPool> pool, const std::vector<std::byte>& bits, QObject* parent = nullptr);
    /// Says goodbye to all nodes, which erase what they have; waits for that a second at most.
    ~RenderNodes() override;

    /// Folder of the certificates for later connections (remote/certificates.h); empty: none, connections to this
    /// machine only.
    void setBundle(const QString& folder);
    /// Dials a node, now and whenever its connection is lost. Errors: a malformed address, no certificates for it.
    Result<NodeId> add(const QString& address);
    void remove(NodeId node);
    void setPaused(NodeId node, bool paused);
    /// Accepts nodes that dial: "4743", "192.0.2.7:4743". Returns the actual address. Errors: malformed, or in use.
    Result<remote::Address> listen(const QString& address);
    void stopListening();

    /// As of the last change.
    const std::vector<NodeStatus>& nodes() const { return nodes_; }
    /// As of now; waits for the network thread.
    std::vector<NodeStatus> look() const;

  signals:
    /// nodes() has changed; at most ten times a second.
    void changed();
    // Emitted in the network thread; receivers in other threads get them queued.
    /// What nodes() will be.
    void seen(const std::vector<pdr::nodes::NodeStatus>& nodes);
    void joined(const pdr::nodes::NodeStatus& node);
    /// A node that took part is gone, other than by the goodbye of this program's end.
    void lost(const pdr::nodes::NodeStatus& node);
    /// A program that dialled was sent away before it had said what it is.
    void turnedAway(const QString& peer, const QString& reason);

  private:
    std::shared_ptr<WorkerPool> pool_;
    QThread thread_;
    NodeDesk* desk_;  ///< lives in thread_
    std::vector<NodeStatus> nodes_;
};

}  // namespace pdr::nodes
