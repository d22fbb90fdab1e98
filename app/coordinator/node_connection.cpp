#include "app/coordinator/node_connection.h"

#include <chrono>
#include <cstring>
#include <utility>
#include <variant>

#include "app/remote/steady_time.h"
#include "app/wire/content.h"
#include "app/wire/content_hash.h"

namespace pdr::nodes {
namespace {

constexpr std::uint32_t kHeartbeatMs = 1000;
/// Minimum time between two scenes: half the rate of messages that a node, and this program, treats as a flood.
constexpr std::chrono::milliseconds kPace{4};
static_assert(2 * std::chrono::seconds(1) / kPace <= remote::ChannelLimits{}.messages.perSecond);

/// Returns what a node is known by: the name of its certificate, which it cannot choose, if no other node has it; else
/// the number of its run.
std::string keyOf(const remote::Channel& channel, const wire::Nonce& boot) {
    if (const QString name = channel.peerCertificate(); !name.isEmpty())
        return name.toStdString();
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (const std::byte byte : boot) {
        text += kDigits[std::to_integer<int>(byte) >> 4];
        text += kDigits[std::to_integer<int>(byte) & 15];
    }
    return text;
}

}  // namespace

wire::Nonce newNonce(std::random_device& random) {
    wire::Nonce nonce;
    for (std::size_t i = 0; i < nonce.size(); i += 4) {
        const std::uint32_t four = random();
        std::memcpy(&nonce[i], &four, sizeof four);
    }
    return nonce;
}

NodeConnection::NodeConnection(remote::Channel* channel, Coordinator& coordinator, QObject* parent)
    : QObject(parent), channel_(channel), coordinator_(coordinator), heart_(remote::steadyTime()) {
    channel_->setParent(this);
    connect(channel_, &remote::Channel::received, this, [this](wire::Message& message) { take(message); });
    connect(channel_, &remote::Channel::roomForMore, this, &NodeConnection::pump);
    connect(channel_, &remote::Channel::closed, this, &NodeConnection::end);
    connect(&beatTimer_, &QTimer::timeout, this, &NodeConnection::beat);
    beatTimer_.start(kHeartbeatMs / 4);
    pace_.setSingleShot(true);
    connect(&pace_, &QTimer::timeout, this, &NodeConnection::pump);
}

NodeConnection::~NodeConnection() {
    channel_->disconnect(this);
    if (worker_)
        coordinator_.leases->leave(*worker_);
}

void NodeConnection::take(wire::Message& message) {
    heart_.heard(remote::steadyTime());
    std::visit([this](auto& one) { take(one); }, message);
}

void NodeConnection::take(const wire::Hello& hello) {
    if (worker_)
        return;
    name_ = QString::fromStdString(hello.name);
    device_ = QString::fromStdString(hello.device + (hello.details.empty() ? "" : ", " + hello.details));
    const std::optional<std::uint16_t> version = wire::commonVersion(coordinator_.versions, hello.versions);
    if (!version)
        return refuse(wire::Refused::Why::version,
                      phrase("it speaks another version of the protocol: %1", hello.program));
    otherBits_ = hello.bits != coordinator_.bits;
    if (otherBits_)
        return refuse(wire::Refused::Why::bits,
                      phrase("its images differ from this machine's in the last bits: it runs a different build"));
    worker_ = coordinator_.leases->join(keyOf(*channel_, hello.boot), hello.name, *version >= wire::kDeepVersion);
    coordinator_.leases->setPaused(*worker_, paused_);
    keepsSums_ = hello.keptPixels.has_value();
    channel_->send(wire::Welcome{*version, kHeartbeatMs, coordinator_.key});
    channel_->setAdmitted();
    emit joined();
    pump();
}

void NodeConnection::refuse(wire::Refused::Why why, const Text& reason) {
    refusal_ = reason;
    channel_->send(wire::Refused{why, reason});
    channel_->close(reason);
}

void NodeConnection::pump() {
    if (!worker_ || !channel_->isOpen())
        return;
    const PublishedScene scene = coordinator_.leases->scene();
    if (scene.number != sent_ && !pace_.isActive()) {
        sendScene(scene);
        pace_.start(kPace);
    }
    sendLeases();
    sendChunks();
}

void NodeConnection::sendScene(const PublishedScene& scene) {
    sent_ = scene.number;
    transfer_.reset();
    stale_ += nonces_.size();
    nonces_.clear();
    sceneTrouble_ = {};
    inLine_ = false;
    if (!scene.scene) {
        scene_.reset();
        coordinator_.scenes.forget();
        channel_->send(wire::Forget{});
        return;
    }
    scene_ = coordinator_.scenes.ready(scene);
    if (scene_)
        channel_->send(scene_->order);
    else
        cannotHave(coordinator_.scenes.reason());
}

void NodeConnection::cannotHave(const Text& reason) {
    sceneTrouble_ = reason;
    coordinator_.leases->cannotTakeScene(*worker_, reason);
}

const Content* NodeConnection::find(const wire::Hash& hash) const {
    if (scene_)
        for (const Content& content : scene_->contents)
            if (content.hash == hash)
                return &content;
    return nullptr;
}

void NodeConnection::take(const wire::Need& need) {
    sceneTrouble_ = {};  // a node that has waited for its turn, or for memory, has it now
    inLine_ = false;
    transfer_ = Transfer{need.content, need.from};
    sendChunks();
}

void NodeConnection::sendChunks() {
    while (transfer_ && channel_->hasRoom()) {
        const Content* content = find(transfer_->hash);
        if (!content || transfer_->next >= wire::chunksOf(content->bytes.size())) {
            transfer_.reset();
            return;
        }
        if (!channel_->send(wire::packChunk(content->hash, content->bytes, transfer_->next)))
            return;
        ++transfer_->next;
    }
}

void NodeConnection::take(const wire::SceneReady& ready) {
    if (ready.revision != sent_ || !scene_)
        return;
    transfer_.reset();
    sceneTrouble_ = {};
    inLine_ = false;
    stale_ = 0;  // a node drops its leases before it loads a scene, and messages arrive in order
    coordinator_.leases->hasScene(*worker_, sent_);
    pump();
}

void NodeConnection::take(const wire::SceneRefused& refused) {
    if (refused.revision != sent_)
        return;
    inLine_ = refused.place.has_value();
    cannotHave(refused.reason);
}

void NodeConnection::sendLeases() {
    while (channel_->isOpen() && channel_->hasRoom()) {
        std::optional<pdr::Lease> lease = coordinator_.leases->take(*worker_);
        if (!lease)
            return;
        const wire::Nonce nonce = nonces_[lease->number] = newNonce(random_);
        wire::Lease sent{lease->number, nonce, lease->scene, lease->tile, lease->samples, {}, {}};
        if (lease->isKept && keepsSums_) {
            sent.kept = wire::sumsHash(coordinator_.key, lease->before, lease->moments);
        } else {
            sent.before = std::move(lease->before);
            sent.moments = std::move(lease->moments);
        }
        channel_->send(std::move(sent));
    }
}

/// Closes a lease and returns its nonce. Nothing: the lease is of an earlier scene; or there was no such lease, and the
/// connection is closed, since unpacking a result costs more than sending one.
std::optional<wire::Nonce> NodeConnection::answered(std::uint64_t lease) {
    if (const auto open = nonces_.extract(lease))
        return open.mapped();
    unasked_ = stale_ == 0;
    if (unasked_)
        channel_->close(phrase("it sends results that nobody asked it for"));
    else
        --stale_;
    return std::nullopt;
}

void NodeConnection::take(wire::Result& result) {
    const std::optional<wire::Nonce> nonce = answered(result.number);
    if (!nonce)
        return;
    if (*nonce != result.nonce || result.revision != sent_) {
        coordinator_.leases->quarantine(*worker_, phrase("it answered a lease that it was not given"));
        return;
    }
    coordinator_.leases->deliver(*worker_, {result.number, result.tile, result.samples, std::move(result.sums),
                                            result.health, result.seconds, std::move(result.moments)});
    sendLeases();
}

void NodeConnection::take(const wire::Abandoned& abandoned) {
    const std::optional<wire::Nonce> nonce = answered(abandoned.number);
    if (!nonce || *nonce != abandoned.nonce)
        return;
    if (!abandoned.reason.empty())  // its device has failed: no more leases of this scene
        cannotHave(abandoned.reason);
    coordinator_.leases->abandon(*worker_, abandoned.number);
}

void NodeConnection::take(const wire::Draining&) {
    coordinator_.leases->setDraining(*worker_);
}

void NodeConnection::take(const wire::Bye& bye) {
    goodbye_ = true;
    channel_->close(bye.reason.empty() ? phrase("it said goodbye") : bye.reason);
}

void NodeConnection::take(const wire::Pong& pong) {
    heart_.answered(pong, remote::steadyTime());
}

void NodeConnection::beat() {
    if (!worker_)
        return;
    const remote::Heartbeat::Peer peer = heart_.at(remote::steadyTime());
    if (const std::optional<wire::Ping> ping = heart_.due(remote::steadyTime()))
        channel_->send(*ping);
    coordinator_.leases->setSuspect(*worker_, peer != remote::Heartbeat::Peer::fine);
    if (peer == remote::Heartbeat::Peer::dead)
        channel_->close(phrase("it has not been heard of for 10 seconds"));
}

void NodeConnection::setPaused(bool paused) {
    paused_ = paused;
    if (worker_)
        coordinator_.leases->setPaused(*worker_, paused);
}

void NodeConnection::leave(const Text& reason) {
    channel_->send(wire::Bye{reason});
    channel_->close(reason);
}

void NodeConnection::end(const Text& reason) {
    beatTimer_.stop();
    pace_.stop();
    if (worker_) {
        const std::optional<WorkerStatus> last = coordinator_.leases->status(*worker_);
        if (last && last->state == WorkerState::quarantined)
            quarantine_ = last->reason;
        coordinator_.leases->leave(*std::exchange(worker_, std::nullopt));
    }
    emit over(isRefused() ? refusal_ : reason);
}

NodeState NodeConnection::stateOf(WorkerState worker) const {
    switch (worker) {
        case WorkerState::waiting:
            if (inLine_)
                return NodeState::waiting;
            return scene_ && sceneTrouble_.empty() ? NodeState::sending : NodeState::ready;
        case WorkerState::ready:
            return NodeState::ready;
        case WorkerState::suspect:
            return NodeState::suspect;
        case WorkerState::paused:
            return NodeState::paused;
        case WorkerState::draining:
            return NodeState::draining;
        case WorkerState::quarantined:
            return NodeState::quarantined;
    }
    return NodeState::lost;
}

NodeStatus NodeConnection::status() const {
    NodeStatus status;
    status.name = name_;
    status.device = device_;
    status.otherBits = otherBits_;
    status.state = isRefused() ? NodeState::refused : NodeState::greeting;
    status.reason = isRefused() ? refusal_ : sceneTrouble_;
    if (transfer_)
        if (const Content* content = find(transfer_->hash))
            status.sent = double(transfer_->next) / wire::chunksOf(content->bytes.size());
    if (const auto latency = heart_.latency())
        status.latencyMs = std::chrono::duration<double, std::milli>(*latency).count();
    status.bytesOut = channel_->bytesSent();
    status.bytesIn = channel_->bytesReceived();
    const std::optional<WorkerStatus> worker = worker_ ? coordinator_.leases->status(*worker_) : std::nullopt;
    if (!worker)
        return status;
    status.work = *worker;
    status.state = stateOf(worker->state);
    if (status.state == NodeState::quarantined)
        status.reason = worker->reason;
    return status;
}

}  // namespace pdr::nodes
