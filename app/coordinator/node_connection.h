#pragma once
/// The coordinator's end of a connection to a node: handshake, scenes, leases, results, heartbeat.
/// Lives in the thread of its channel.

#include <QObject>
#include <map>
#include <memory>
#include <optional>
#include <random>

#include "app/coordinator/node_status.h"
#include "app/coordinator/outgoing_scenes.h"
#include "app/remote/channel.h"
#include "app/remote/heartbeat.h"
#include "render/tiles/lease_server.h"

namespace pdr::nodes {

/// State that all links of a coordinator share.
struct Coordinator {
    std::shared_ptr<LeaseServer> leases;
    ContentKey key{};
    wire::Hash bits{};  ///< hash of the own device's reference tiles
    OutgoingScenes scenes{key};
    wire::Versions versions;  ///< supported versions of the protocol
};

class NodeConnection : public QObject {
    Q_OBJECT

  public:
    /// Takes ownership of `channel`. `coordinator` must outlive it.
    NodeConnection(remote::Channel* channel, Coordinator& coordinator, QObject* parent = nullptr);
    ~NodeConnection() override;

    /// Sends what there is to send: a new scene, leases, chunks. Scenes that change fast are throttled, but the last
    /// one is always sent.
    void pump();
    void setPaused(bool paused);
    /// Sends a Bye, upon which the node erases all its contents, and closes the connection.
    void leave(const Text& reason);
    /// Returns the status of the node without id, address, dialled and losses.
    NodeStatus status() const;
    /// Whether the node was refused (version, bits): dialling again would not help.
    bool isRefused() const { return !refusal_.empty(); }
    /// Reason for the node's quarantine, known once the connection is over; empty: it was not quarantined.
    const Text& quarantine() const { return quarantine_; }
    /// Whether the node has closed the connection with a Bye.
    bool hasSaidGoodbye() const { return goodbye_; }
    /// Whether the connection was closed because the node sent too much, or answers to no lease.
    bool wasFlooded() const { return unasked_ || channel_->wasFlooded(); }

  signals:
    /// The handshake has succeeded.
    void joined();
    /// The connection is over; the last signal.
    void over(const pdr::Text& reason);

  private:
    /// A content that is being sent.
    struct Transfer {
        wire::Hash hash;
        std::uint32_t next = 0;
    };

    void take(wire::Message& message);
    void take(const wire::Hello& hello);
    void take(const wire::Pong& pong);
    void take(const wire::Need& need);
    void take(const wire::SceneReady& ready);
    void take(const wire::SceneRefused& refused);
    void take(wire::Result& result);
    void take(const wire::Abandoned& abandoned);
    void take(const wire::Draining&);
    void take(const wire::Bye& bye);
    /// Ignores messages that a node never sends: the codec refuses them.
    template <class Other>
    void take(const Other&) {}

    std::optional<wire::Nonce> answered(std::uint64_t lease);
    void refuse(wire::Refused::Why why, const Text& reason);
    void sendScene(const PublishedScene& scene);
    void cannotHave(const Text& reason);
    void sendChunks();
    void sendLeases();
    void beat();
    void end(const Text& reason);
    const Content* find(const wire::Hash& hash) const;
    NodeState stateOf(WorkerState worker) const;

    remote::Channel* channel_;
    Coordinator& coordinator_;
    remote::Heartbeat heart_;
    QTimer beatTimer_;
    QTimer pace_;  ///< runs while no other scene may be sent
    std::optional<WorkerId> worker_;
    QString name_, device_;
    Text refusal_, sceneTrouble_, quarantine_;
    bool otherBits_ = false;
    bool unasked_ = false;  ///< an answer to no lease has arrived
    bool goodbye_ = false;
    bool paused_ = false;
    bool keepsSums_ = false;                      ///< the node understands Lease::kept
    bool inLine_ = false;                         ///< the node takes the scene when other coordinators have left it
    std::uint64_t sent_ = 0;                      ///< number of the scene sent last
    std::shared_ptr<const OutgoingScene> scene_;  ///< the scene sent last; null: none
    std::optional<Transfer> transfer_;
    std::map<std::uint64_t, wire::Nonce> nonces_;  ///< nonces of open leases, by number of the lease
    std::size_t stale_ = 0;                        ///< open leases of earlier scenes; answers may still arrive
    std::random_device random_;
};

/// Returns cryptographically random bytes.
wire::Nonce newNonce(std::random_device& random);

}  // namespace pdr::nodes
