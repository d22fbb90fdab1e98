#include "app/node/node_session.h"

#include <utility>
#include <variant>

#include "app/remote/steady_time.h"
#include "render/tiles/lease_server.h"

namespace pdr::node {
namespace {

/// Limit on open leases. A coordinator gives out LeaseServer::kInFlight at a time; many times that is an attack on
/// memory.
constexpr std::size_t kMostLeases = 64;
static_assert(kMostLeases >= 16 * std::size_t(LeaseServer::kInFlight));

/// Number of heartbeats without a byte from the coordinator after which it counts as dead.
constexpr int kMostSilentBeats = 10;

}  // namespace

NodeSession::NodeSession(remote::Channel* channel, const wire::Hello& hello, NodeContents& contents,
                         LeaseRenderer& renderer, QObject* parent)
    : QObject(parent), channel_(channel), contents_(contents), renderer_(renderer), versions_(hello.versions) {
    channel_->setParent(this);
    connect(channel_, &remote::Channel::received, this, [this](wire::Message& message) { take(message); });
    connect(channel_, &remote::Channel::closed, this, [this](const Text& reason) {
        beatTimer_.stop();
        dropLeases();
        emit over(reason);
    });
    connect(&beatTimer_, &QTimer::timeout, this, &NodeSession::beat);
    channel_->send(hello);
}

NodeSession::~NodeSession() {
    channel_->disconnect(this);
}

void NodeSession::take(wire::Message& message) {
    std::visit([this](auto& one) { take(one); }, message);
}

void NodeSession::take(const wire::Welcome& welcome) {
    if (welcome.version < versions_.lowest || welcome.version > versions_.highest)
        return take(wire::Refused{wire::Refused::Why::version,
                                  phrase("the coordinator speaks a version of the protocol that it was not offered")});
    contents_.setKey(welcome.key);
    channel_->setAdmitted();
    listenToHeart(std::chrono::milliseconds(welcome.heartbeatMs));
    emit this->welcome();
}

/// Starts to watch the coordinator, which sends a Ping every `interval`. A coordinator that hangs keeps its connection,
/// and would keep the node occupied.
void NodeSession::listenToHeart(std::chrono::milliseconds interval) {
    const auto dead = kMostSilentBeats * interval;
    heart_.emplace(remote::steadyTime(), remote::HeartbeatLimits{interval, dead, dead});
    beatTimer_.start(interval / 4);
}

void NodeSession::beat() {
    if (const qint64 bytes = channel_->bytesReceived(); bytes != heardBytes_) {
        heardBytes_ = bytes;
        heart_->heard(remote::steadyTime());
    }
    if (heart_->at(remote::steadyTime()) != remote::Heartbeat::Peer::dead)
        return;
    beatTimer_.stop();
    channel_->close(phrase("the coordinator has not been heard of for %1 heartbeats", kMostSilentBeats));
}

void NodeSession::take(const wire::Refused& refused) {
    refusal_ = refused;
    dismissed_ = true;
    channel_->close(refused.reason);
}

void NodeSession::take(const wire::Ping& ping) {
    channel_->send(wire::Pong{ping.number});
}

void NodeSession::take(const wire::SceneOrder& order) {
    dropLeases();
    revision_ = order.revision;
    if (const Result<void> begun = contents_.order(order); !begun)
        return refuseScene(begun.error().what);
    askOrRender();
}

void NodeSession::askOrRender() {
    if (const std::optional<wire::Need> need = contents_.need()) {
        channel_->send(*need);
        return;
    }
    Result<Scene> scene = contents_.scene();
    if (!scene)
        return refuseScene(scene.error().what);
    renderer_.setScene(revision_, std::make_shared<const Scene>(*std::move(scene)));
}

void NodeSession::take(const wire::Chunk& chunk) {
    const Result<bool> whole = contents_.add(chunk);
    if (!whole)
        channel_->close(whole.error().what);
    else if (*whole)
        askOrRender();
}

void NodeSession::take(wire::Lease& lease) {
    if (draining_ || revision_ == 0 || lease.revision != revision_) {
        channel_->send(wire::Abandoned{lease.number, lease.nonce, {}});
        return;
    }
    if (leases_.size() >= kMostLeases || leases_.contains(lease.number))
        return channel_->close(phrase("the coordinator gives out leases twice, or more than a node can have"));
    leases_[lease.number] = {lease.nonce, lease.revision};
    renderer_.add(
        {lease.number, lease.revision, lease.tile, lease.samples, std::move(lease.before), std::move(lease.moments)});
    emit worked();
}

void NodeSession::take(const wire::Forget&) {
    dropLeases();
    revision_ = 0;
    contents_.forget();
    renderer_.forget();
}

void NodeSession::take(const wire::Bye& bye) {
    dismissed_ = true;
    channel_->close(bye.reason);
}

/// Drops all leases: their scene is outdated, or the connection is over.
void NodeSession::dropLeases() {
    leases_.clear();
    renderer_.drop();
}

void NodeSession::answer(LeaseAnswer answer) {
    std::visit([this](auto& one) { say(std::move(one)); }, answer);
}

void NodeSession::say(const SceneTaken& taken) {
    if (taken.scene != revision_)
        return;
    if (taken.error)
        refuseScene(taken.error->text());
    else
        channel_->send(wire::SceneReady{taken.scene});
}

void NodeSession::refuseScene(const Text& reason) {
    channel_->send(wire::SceneRefused{revision_, reason});
}

void NodeSession::say(LeaseResult result) {
    const auto lease = leases_.find(result.number);
    if (lease == leases_.end())
        return;
    const Taken taken = lease->second;
    leases_.erase(lease);
    channel_->send(wire::Result{result.number, taken.nonce, taken.revision, result.tile, result.samples,
                                std::move(result.sums), result.health, result.seconds, std::move(result.moments)});
    lookWhetherDrained();
}

void NodeSession::say(const LeaseLost& lost) {
    const auto lease = leases_.find(lost.lease);
    if (lease == leases_.end())
        return;
    channel_->send(wire::Abandoned{lost.lease, lease->second.nonce, lost.error.text()});
    leases_.erase(lease);
    lookWhetherDrained();
}

void NodeSession::drain() {
    draining_ = true;
    channel_->send(wire::Draining{});
    lookWhetherDrained();
}

void NodeSession::lookWhetherDrained() {
    if (draining_ && leases_.empty())
        emit drained();
}

void NodeSession::leave(const Text& reason) {
    for (const auto& [number, taken] : leases_)
        channel_->send(wire::Abandoned{number, taken.nonce, {}});
    channel_->send(wire::Bye{reason});
    dropLeases();
    channel_->close(phrase("this node has said goodbye"));
}

}  // namespace pdr::node
