#pragma once
/// The node's end of one connection: handshake, scenes, leases, results. Lives in the thread of its channel.

#include <QObject>
#include <QTimer>
#include <map>
#include <optional>

#include "app/node/kept_sums.h"
#include "app/node/node_seats.h"
#include "app/remote/channel.h"
#include "app/remote/heartbeat.h"

namespace pdr::node {

class NodeSession : public QObject {
    Q_OBJECT

  public:
    /// Takes ownership of `channel`; `seats` must outlive it.
    NodeSession(remote::Channel* channel, const wire::Hello& hello, NodeSeats& seats, QObject* parent = nullptr);
    ~NodeSession() override;

    // Called by the seats.
    /// Begins with the scene that the coordinator has ordered last, at `seat`, which lasts until NodeSeats::leave().
    void sit(NodeSeat& seat);
    /// Gives the seat up, and waits in line.
    void rise();
    /// Tells the coordinator its place in line, from 1.
    void wait(std::uint32_t place);
    /// Begins with the scene again if there was not enough memory for it.
    void tryAgain();
    /// Tells the coordinator that its scene cannot be rendered.
    void refuseScene(const Text& reason);
    /// Sends an answer of the renderer to the coordinator.
    void answer(LeaseAnswer answer);

    /// Returns the secret by which the coordinator is known again, after welcome().
    const nodes::ContentKey& key() const { return key_; }
    /// Whether leases are open.
    bool isBusy() const { return !leases_.empty(); }
    /// Returns the time that the leases and scenes of the coordinator have taken, as the turns count it [s].
    double seconds() const { return seconds_ + (seat_ ? seat_->renderer->seconds() : 0); }
    /// Accepts no new leases; emits drained() when all are answered.
    void drain();
    /// Gives open leases back, sends a Bye and closes the connection. `reason`: for the coordinator's user; may be
    /// empty.
    void leave(const Text& reason);
    const std::optional<wire::Refused>& refusal() const { return refusal_; }

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
    void beginScene();
    void tell(wire::SceneRefused refused);
    void askOrRender();
    bool fillIn(Lease& lease, const wire::Hash& kept) const;
    void leaveSeat(bool isLost);
    void dropLeases();
    void lookWhetherDrained();
    void listenToHeart(std::chrono::milliseconds interval);
    void beat();

    remote::Channel* channel_;
    NodeSeats& seats_;
    NodeSeat* seat_ = nullptr;  ///< null: there is no scene, or it waits in line
    nodes::ContentKey key_{};
    double seconds_ = 0;                      ///< time at earlier seats, less what the present one had had before [s]
    wire::Versions versions_;                 ///< versions of the protocol that this node has offered
    std::optional<remote::Heartbeat> heart_;  ///< heartbeat of the coordinator; none before its Welcome
    QTimer beatTimer_;
    qint64 heardBytes_ = 0;                   ///< received bytes at the last beat()
    std::uint64_t revision_ = 0;              ///< revision of the newest requested scene; 0: none
    wire::SceneOrder order_;                  ///< the order of that scene
    bool lacksMemory_ = false;                ///< there was not enough memory for it
    std::optional<wire::SceneRefused> told_;  ///< why it cannot be rendered, as told last; none: it can
    std::map<std::uint64_t, Taken> leases_;
    KeptSums kept_;
    std::optional<wire::Refused> refusal_;
    bool dismissed_ = false;  ///< the coordinator has sent a Bye or refused this node: its scan must be erased
    bool draining_ = false;
};

}  // namespace pdr::node
