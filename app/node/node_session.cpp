#include "app/node/node_session.h"

#include <utility>
#include <variant>

#include "app/remote/steady_time.h"
#include "app/wire/content_hash.h"
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

NodeSession::NodeSession(remote::Channel* channel, const wire::Hello& hello, NodeSeats& seats, QObject* parent)
    : QObject(parent), channel_(channel), seats_(seats), versions_(hello.versions) {
    channel_->setParent(this);
    connect(channel_, &remote::Channel::received, this, [this](wire::Message& message) { take(message); });
    connect(channel_, &remote::Channel::closed, this, [this](const Text& reason) {
        beatTimer_.stop();
        leaveSeat(!dismissed_);
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
    key_ = welcome.key;
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
    order_ = order;
    told_.reset();
    seats_.worked(*this);
    if (seat_)
        beginScene();
    else
        seats_.ask(*this);
}

void NodeSession::sit(NodeSeat& seat) {
    seat_ = &seat;
    seconds_ -= seat.renderer->seconds();
    beginScene();
}

void NodeSession::rise() {
    dropLeases();
    lacksMemory_ = false;
    seconds_ = seconds();
    seat_ = nullptr;
}

void NodeSession::wait(std::uint32_t place) {
    tell({revision_, phrase("number %1 in the line, since others use this render node", place), place});
}

void NodeSession::beginScene() {
    const Result<void> begun = seat_->contents.order(order_);
    lacksMemory_ = !begun;
    if (!begun)
        return refuseScene(begun.error().what);
    told_.reset();
    askOrRender();
}

void NodeSession::tryAgain() {
    if (lacksMemory_)
        beginScene();
}

void NodeSession::askOrRender() {
    if (const std::optional<wire::Need> need = seat_->contents.need()) {
        channel_->send(*need);
        return;
    }
    Result<Scene> scene = seat_->contents.scene();
    if (!scene) {
        seat_->contents.settle();
        return refuseScene(scene.error().what);
    }
    seat_->renderer->setScene(revision_, std::make_shared<const Scene>(*std::move(scene)));
}

void NodeSession::take(const wire::Chunk& chunk) {
    if (!seat_)
        return;  // a chunk of a scene that was taken back
    seats_.worked(*this);
    const Result<bool> whole = seat_->contents.add(chunk);
    if (!whole)
        channel_->close(whole.error().what);
    else if (*whole)
        askOrRender();
}

void NodeSession::take(wire::Lease& lease) {
    if (draining_ || !seat_ || lease.revision != revision_) {
        channel_->send(wire::Abandoned{lease.number, lease.nonce, {}});
        return;
    }
    if (leases_.size() >= kMostLeases || leases_.contains(lease.number))
        return channel_->close(phrase("the coordinator gives out leases twice, or more than a node can have"));
    Lease taken{lease.number,  lease.revision,          lease.tile,
                lease.samples, std::move(lease.before), std::move(lease.moments)};
    if (lease.kept && !fillIn(taken, *lease.kept)) {
        channel_->send(wire::Abandoned{lease.number, lease.nonce, {}});
        return;
    }
    leases_[lease.number] = {lease.nonce, lease.revision};
    seats_.worked(*this);
    seat_->renderer->add(std::move(taken));
    emit worked();
}

void NodeSession::take(const wire::Forget&) {
    leaveSeat(false);
}

void NodeSession::take(const wire::Bye& bye) {
    dismissed_ = true;
    channel_->close(bye.reason);
}

/// Fills in what the lease continues if it is here and has that hash.
bool NodeSession::fillIn(Lease& lease, const wire::Hash& kept) const {
    return kept_.fill(lease) && wire::sumsHash(key_, lease.before, lease.moments) == kept;
}

/// Drops all leases: their scene is outdated, or the connection is over.
void NodeSession::dropLeases() {
    leases_.clear();
    kept_.clear();
    if (seat_)
        seat_->renderer->drop();
}

void NodeSession::leaveSeat(bool isLost) {
    dropLeases();
    revision_ = 0;
    order_ = {};
    lacksMemory_ = false;
    seconds_ = seconds();
    seat_ = nullptr;
    seats_.leave(*this, isLost);
}

void NodeSession::answer(LeaseAnswer answer) {
    std::visit([this](auto& one) { say(std::move(one)); }, answer);
}

void NodeSession::say(const SceneTaken& taken) {
    if (taken.scene != revision_)
        return;
    seat_->contents.settle();
    if (taken.error)
        refuseScene(taken.error->text());
    else
        channel_->send(wire::SceneReady{taken.scene});
    seats_.advance();
}

void NodeSession::refuseScene(const Text& reason) {
    tell({revision_, reason, std::nullopt});
}

/// Says it once, since scenes are tried again whenever another coordinator goes.
void NodeSession::tell(wire::SceneRefused refused) {
    if (told_ == refused)
        return;
    channel_->send(refused);
    told_ = std::move(refused);
}

void NodeSession::say(LeaseResult result) {
    const auto lease = leases_.find(result.number);
    if (lease == leases_.end())
        return;
    const Taken taken = lease->second;
    leases_.erase(lease);
    seats_.worked(*this);
    kept_.keep(result);
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
    leaveSeat(true);
    channel_->close(phrase("this node has said goodbye"));
}

}  // namespace pdr::node
