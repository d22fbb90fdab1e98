#pragma once
/// The node's end of one connection: handshake, scenes, leases, results. Lives in the thread of its channel.

#include <QObject>
#include <QTimer>
#include <map>
#include <optional>

#include "app/node/node_contents.h"
#include "app/remote/channel.h"
#include "app/remote/heartbeat.h"
#include "render/tiles/lease_renderer.h"

namespace pdr::node {

class NodeSession : public QObject {
    Q_OBJECT

  public:
    /// Takes ownership of `channel`; the rest must outlive it.
    NodeSession(remote::Channel* channel, const wire::Hello& hello, NodeContents& contents, LeaseRenderer& renderer,
                QObject* parent = nullptr);
    ~NodeSession() override;

    /// Sends an answer of the renderer to the coordinator.
    void answer(LeaseAnswer answer);
    /// Accepts no new leases; emits drained() when all are answered.
    void drain();
    /// Gives open leases back, sends a Bye and closes the connection. `reason`: for the coordinator's user; may be
    /// empty.
    void leave(const Text& reason);
    bool isWelcome() const { return channel_->isAdmitted(); }
    /// Whether the coordinator has sent a Bye or refused this node: its contents must be erased.
    bool wasDismissed() const { return dismissed_; }
    const std::optional<wire::Refused>& refusal() const { return refusal_; }
    /// Whether leases are open.
    bool isBusy() const { return !leases_.empty(); }

  signals:
    /// The handshake has succeeded.
    void welcome();
    /// A lease has arrived.
    void worked();
    /// No lease is open any more, after drain().
    void drained();
    /// The connection is over; the last signal.
    void over(const pdr::Text& reason);

  private:
    struct Taken {
        wire::Nonce nonce;
        std::uint64_t revision;
    };

    void take(wire::Message& message);
    void take(const wire::Welcome& welcome);
    void take(const wire::Refused& refused);
    void take(const wire::Ping& ping);
    void take(const wire::SceneOrder& order);
    void take(const wire::Chunk& chunk);
    void take(wire::Lease& lease);
    void take(const wire::Forget&);
    void take(const wire::Bye& bye);
    /// Ignores messages that a coordinator never sends: the codec refuses them.
    template <class Other>
    void take(const Other&) {}

    void say(const SceneTaken& taken);
    void say(LeaseResult result);
    void say(const LeaseLost& lost);
    void askOrRender();
    void refuseScene(const Text& reason);
    void dropLeases();
    void lookWhetherDrained();
    void listenToHeart(std::chrono::milliseconds interval);
    void beat();

    remote::Channel* channel_;
    NodeContents& contents_;
    LeaseRenderer& renderer_;
    wire::Versions versions_;                 ///< versions of the protocol that this node has offered
    std::optional<remote::Heartbeat> heart_;  ///< heartbeat of the coordinator; none before its Welcome
    QTimer beatTimer_;
    qint64 heardBytes_ = 0;       ///< received bytes at the last beat()
    std::uint64_t revision_ = 0;  ///< revision of the newest requested scene; 0: none
    std::map<std::uint64_t, Taken> leases_;
    std::optional<wire::Refused> refusal_;
    bool dismissed_ = false;
    bool draining_ = false;
};

}  // namespace pdr::node
