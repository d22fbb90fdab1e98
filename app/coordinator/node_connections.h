#pragma once
/// Dials nodes, accepts nodes that dial, and redials lost ones. Lives in the network thread of RenderNodes.

#include <QObject>
#include <QTimer>
#include <atomic>
#include <memory>
#include <vector>

#include "app/coordinator/node_connection.h"
#include "app/remote/backoff.h"
#include "app/remote/dial.h"
#include "app/remote/listener.h"

namespace pdr::nodes {

class NodeConnections : public QObject {
    Q_OBJECT

  public:
    NodeConnections(std::shared_ptr<LeaseServer> leases, const wire::Hash& bits);
    ~NodeConnections() override;

    void setBundle(const QString& folder) { bundle_ = folder; }
    Result<NodeId> add(const QString& address);
    void remove(NodeId node);
    void setPaused(NodeId node, bool paused);
    Result<remote::Address> listen(const QString& address);
    void stopListening();
    std::vector<NodeStatus> nodes() const;
    /// Disconnects all nodes; emits empty() after the last one.
    void close();

  signals:
    void changed(const std::vector<pdr::nodes::NodeStatus>& nodes);
    void joined(const pdr::nodes::NodeStatus& node);
    void lost(const pdr::nodes::NodeStatus& node);
    void turnedAway(const QString& peer, const QString& reason);
    void empty();

  private:
    struct Node {
        NodeStatus status;                       ///< status that is used while there is no link
        std::optional<remote::Address> address;  ///< address to dial; none: the node dialled, or is being removed
        remote::Identity identity;
        remote::Backoff backoff{{.giveUp = std::chrono::hours(24 * 365)}};  ///< never gives up: the user decides
        bool paused = false;
        NodeConnection* link = nullptr;
        remote::Dial* dial = nullptr;
        QTimer* again = nullptr;  ///< dials again
    };

    Node* find(NodeId id);
    void dial(Node& node);
    void dialLater(Node& node, const Text& reason);
    void connected(Node& node, remote::Channel* channel);
    void accepted(remote::Channel* channel);
    void ended(NodeId id, const Text& reason);
    NodeStatus statusOf(const Node& node) const;
    void pump();
    void tell();

    Coordinator coordinator_;
    QString bundle_;
    std::unique_ptr<remote::Listener> listener_;
    std::vector<std::unique_ptr<Node>> nodes_;
    NodeId next_ = 1;
    QTimer tick_;     ///< calls LeaseServer::tick()
    QTimer telling_;  ///< emits changed()
    bool closing_ = false;
    std::atomic<bool> pumpIsDue_ = false;
    std::mt19937_64 random_{std::random_device()()};
};

}  // namespace pdr::nodes
