#pragma once
/// The coordinator's end of a connection to a node: greets it, sends it scenes, hands it leases of a WorkerPool and
/// takes its results. Lives in the thread of its channel.

#include <QObject>
#include <map>
#include <memory>
#include <optional>
#include <random>

#include "app/nodes/node_status.h"
#include "app/nodes/outgoing_scenes.h"
#include "app/remote/channel.h"
#include "app/remote/heartbeat.h"
#include "render/tiles/worker_pool.h"

namespace pdr::nodes {

/// What all links of a coordinator have in common.
struct Coordinator {
    std::shared_ptr<WorkerPool> pool;
    ContentKey key{};
    wire::Hash bits{};  ///< what the reference tiles come to on the own device
    OutgoingScenes scenes{key};
    wire::Versions versions;  ///< of the protocol, that it speaks
};

class NodeLink : public QObject {
    Q_OBJECT

  public:
    /// Takes `channel` over. `coordinator` must outlive it.
    NodeLink(remote::Channel* channel, Coordinator& coordinator, QObject* parent = nullptr);
    ~NodeLink() override;

    /// There may be a scene to send or work to take. Of scenes that change faster than any screen shows them only some
    /// are sent, the last one in any case: no more than the other side takes for a flood.
    void pump();
    void setPaused(bool paused);
    /// Says goodbye: the node forgets all that it has.
    void leave(const QString& reason);
    /// All but id, address, dialled and losses.
    NodeStatus status() const;
    /// It was turned away for what it is: to dial it again would not help.
    bool isRefused() const { return !refusal_.isEmpty(); }
    /// It said more than it was asked, and was parted with for that.
    bool wasFlooded() const { return unasked_ || channel_->wasFlooded(); }

  signals:
    /// It has introduced itself and is welcome.
    void joined();
    /// The connection is over; the last signal.
    void over(const QString& reason);

  private:
    /// A content on its way.
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
    /// What a node never sends: the codec has refused it.
    template <class Other>
    void take(const Other&) {}

    std::optional<wire::Nonce> answered(std::uint64_t lease);
    void refuse(wire::Refused::Why why, const QString& reason);
    void sendScene(const PublishedScene& scene);
    void cannotHave(const std::string& reason);
    void sendChunks();
    void sendLeases();
    void beat();
    void end(const QString& reason);
    const Content* find(const wire::Hash& hash) const;
    NodeState stateOf(WorkerState worker) const;

    remote::Channel* channel_;
    Coordinator& coordinator_;
    remote::Heartbeat heart_;
    QTimer beatTimer_;
    QTimer pace_;  ///< runs until another scene may be sent
    std::optional<WorkerId> worker_;
    QString name_, device_, refusal_, sceneTrouble_;
    bool otherBits_ = false;
    bool unasked_ = false;  ///< an answer came that nobody asked for
    bool paused_ = false;
    std::uint64_t sent_ = 0;                      ///< number of the scene that it was sent
    std::shared_ptr<const OutgoingScene> scene_;  ///< that; null: none
    std::optional<Transfer> transfer_;
    std::map<std::uint64_t, wire::Nonce> nonces_;  ///< of leases that it has
    std::size_t stale_ = 0;                        ///< leases of earlier scenes whose answers may be on their way
    std::random_device random_;
};

/// Random bytes that nobody else can guess.
wire::Nonce newNonce(std::random_device& random);

}  // namespace pdr::nodes
