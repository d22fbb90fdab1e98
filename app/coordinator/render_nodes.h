#pragma once
/// Manages all render nodes of a coordinator: dials nodes that were added, accepts nodes that dial, and connects both
/// to a LeaseServer. Runs a network thread of its own. Call it from one thread, which receives changed().

#include <QObject>
#include <QThread>
#include <memory>
#include <optional>

#include "app/coordinator/node_status.h"
#include "app/remote/address.h"
#include "render/tiles/lease_server.h"

namespace pdr::nodes {

class NodeConnections;

class RenderNodes : public QObject {
    Q_OBJECT

  public:
    /// `bits`: referenceTiles() of the own device; nodes with other bits are refused.
    RenderNodes(std::shared_ptr<LeaseServer> leases, const std::vector<std::byte>& bits, QObject* parent = nullptr);
    /// Sends a Bye to all nodes, upon which they erase their contents; waits for that one second at most.
    ~RenderNodes() override;

    /// Sets the folder of the certificates for later connections (remote/certificates.h); empty: no certificates,
    /// connections to this machine only.
    void setBundle(const QString& folder);
    /// Dials a node, now and whenever its connection is lost. Errors: a malformed address, no certificates for it, a
    /// node that was added already.
    Result<NodeId> add(const QString& address);
    void remove(NodeId node);
    void setPaused(NodeId node, bool paused);
    /// Accepts nodes that dial: "4743", "192.0.2.7:4743". Returns the actual address. Errors: malformed, or in use.
    Result<remote::Address> listen(const QString& address);
    void stopListening();

    /// Status of all nodes as of the last changed().
    const std::vector<NodeStatus>& nodes() const { return nodes_; }
    /// Returns the current status of all nodes; waits for the network thread.
    std::vector<NodeStatus> look() const;

  signals:
    /// nodes() has changed; at most ten times a second.
    void changed();
    // Emitted in the network thread; receivers in other threads get them queued.
    /// The status of all nodes has changed; nodes() will return `nodes` later.
    void seen(const std::vector<pdr::nodes::NodeStatus>& nodes);
    /// The handshake with a node has succeeded.
    void joined(const pdr::nodes::NodeStatus& node);
    /// The connection to a node that had joined is over, other than by the end of this program.
    void lost(const pdr::nodes::NodeStatus& node);
    /// A peer that dialled was turned away before it had proved its role.
    void turnedAway(const QString& peer, const QString& reason);

  private:
    std::shared_ptr<LeaseServer> leases_;
    QThread thread_;
    NodeConnections* desk_;  ///< lives in thread_
    std::vector<NodeStatus> nodes_;
};

}  // namespace pdr::nodes
