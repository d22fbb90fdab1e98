#include "app/coordinator/node_connections.h"

#include <algorithm>
#include <chrono>
#include <random>
#include <utility>

#include "app/remote/steady_time.h"

namespace pdr::nodes {
namespace {

constexpr int kTickMs = 100, kTellMs = 100;

ContentKey newKey() {
    std::random_device random;
    ContentKey key;
    for (std::byte& byte : key)
        byte = std::byte(random());
    return key;
}

}  // namespace

NodeConnections::NodeConnections(std::shared_ptr<LeaseServer> leases, const wire::Hash& bits)
    : coordinator_{std::move(leases), newKey(), bits} {
    tick_.setParent(this);
    telling_.setParent(this);
    connect(&tick_, &QTimer::timeout, this, [this] { coordinator_.leases->tick(); });
    connect(&telling_, &QTimer::timeout, this, &NodeConnections::tell);
    coordinator_.leases->setNotice([this] {
        if (!pumpIsDue_.exchange(true))
            QMetaObject::invokeMethod(this, &NodeConnections::pump, Qt::QueuedConnection);
    });
}

NodeConnections::~NodeConnections() {
    coordinator_.leases->setNotice({});
    for (const auto& node : nodes_)
        delete node->link;
}

NodeConnections::Node* NodeConnections::find(NodeId id) {
    const auto found = std::ranges::find_if(nodes_, [&](const auto& node) { return node->status.id == id; });
    return found == nodes_.end() ? nullptr : found->get();
}

Result<NodeId> NodeConnections::add(const QString& text) {
    const Result<remote::Address> address = remote::parseAddress(text);
    if (!address)
        return address.error();
    Result<remote::Identity> identity = remote::identityFor(*address, bundle_, remote::Role::coordinator);
    if (!identity)
        return identity.error();
    if (std::ranges::any_of(nodes_, [&](const auto& node) { return node->address == *address; }))
        return Error{phrase("this render node is named already"), address->text().toStdString(),
                     phrase("Name each node once."), ErrorKind::refused};
    auto node = std::make_unique<Node>();
    node->status.id = next_++;
    node->status.address = address->text();
    node->status.dialled = true;
    node->address = *address;
    node->identity = *std::move(identity);
    nodes_.push_back(std::move(node));
    dial(*nodes_.back());
    telling_.start(kTellMs);
    tick_.start(kTickMs);
    return nodes_.back()->status.id;
}

void NodeConnections::dial(Node& node) {
    node.status.state = NodeState::dialling;
    node.dial = new remote::Dial(*node.address, node.identity, {}, this);
    const NodeId id = node.status.id;
    connect(node.dial, &remote::Dial::connected, this, [this, id](remote::Channel* channel) {
        if (Node* found = find(id))
            connected(*found, channel);
    });
    connect(node.dial, &remote::Dial::failed, this, [this, id](const Error& error) {
        Node* found = find(id);
        if (!found)
            return;
        std::exchange(found->dial, nullptr)->deleteLater();
        if (error.kind == ErrorKind::refused) {
            found->status.state = NodeState::refused;
            found->status.reason = error.what;
        } else {
            dialLater(*found, error.what);
        }
    });
}

void NodeConnections::dialLater(Node& node, const Text& reason) {
    node.status.reason = reason;
    const auto wait = node.backoff.failed(remote::steadyTime(), std::generate_canonical<double, 53>(random_));
    if (!node.again) {
        node.again = new QTimer(this);
        node.again->setSingleShot(true);
        const NodeId id = node.status.id;
        connect(node.again, &QTimer::timeout, this, [this, id] {
            if (Node* found = find(id))
                dial(*found);
        });
    }
    node.again->start(wait.value_or(std::chrono::seconds(10)));
}

void NodeConnections::connected(Node& node, remote::Channel* channel) {
    const NodeId id = node.status.id;
    node.link = new NodeConnection(channel, coordinator_, this);
    node.link->setPaused(node.paused);
    if (node.dial)
        std::exchange(node.dial, nullptr)->deleteLater();
    connect(node.link, &NodeConnection::joined, this, [this, id] {
        if (Node* found = find(id)) {
            found->status.reason = {};
            emit joined(statusOf(*found));
        }
    });
    connect(node.link, &NodeConnection::over, this, [this, id](const Text& reason) { ended(id, reason); });
}

void NodeConnections::accepted(remote::Channel* channel) {
    auto node = std::make_unique<Node>();
    node->status.id = next_++;
    node->status.address = channel->peerName();
    nodes_.push_back(std::move(node));
    connected(*nodes_.back(), channel);
    telling_.start(kTellMs);
    tick_.start(kTickMs);
}

void NodeConnections::ended(NodeId id, const Text& reason) {
    Node* node = find(id);
    if (!node)
        return;
    // Keep the last status of the link
    NodeConnection* link = std::exchange(node->link, nullptr);
    const NodeStatus last = link->status();
    const bool wasKnown = !last.name.isEmpty() && !link->isRefused();
    node->status.name = last.name;
    node->status.device = last.device;
    node->status.otherBits = last.otherBits;
    const bool lied = !link->quarantine().empty();
    node->status.reason = lied ? link->quarantine() : reason;
    node->status.state = link->isRefused() ? NodeState::refused : lied ? NodeState::quarantined : NodeState::lost;
    link->deleteLater();
    // Report the loss
    if (wasKnown) {
        if (!link->wasFlooded())  // the waits of a flooding node keep growing
            node->backoff.succeeded();
        node->status.saidGoodbye = link->hasSaidGoodbye();
        if (!node->status.saidGoodbye)
            ++node->status.losses;
        if (!closing_)
            emit lost(node->status);
    } else if (link->isRefused()) {
        tell();  // report the reason now: a node that dialled is removed below
    }
    // Remove or redial the node
    if (!node->address || closing_)
        remove(id);
    else if (node->status.state == NodeState::lost)
        dialLater(*node, reason);
}

NodeStatus NodeConnections::statusOf(const Node& node) const {
    if (!node.link)
        return node.status;
    NodeStatus status = node.link->status();
    status.id = node.status.id;
    status.address = node.status.address;
    status.dialled = node.status.dialled;
    status.losses = node.status.losses;
    return status;
}

void NodeConnections::remove(NodeId id) {
    Node* node = find(id);
    if (!node)
        return;
    if (node->link) {  // ended() removes it
        node->address.reset();
        node->link->leave(phrase("it is not needed any more"));
        return;
    }
    delete node->dial;
    delete node->again;
    std::erase_if(nodes_, [&](const auto& one) { return one.get() == node; });
    tell();
    if (closing_ && nodes_.empty())
        emit empty();
}

void NodeConnections::setPaused(NodeId id, bool paused) {
    if (Node* node = find(id)) {
        node->paused = paused;
        if (node->link)
            node->link->setPaused(paused);
    }
}

Result<remote::Address> NodeConnections::listen(const QString& text) {
    const Result<remote::Address> address = remote::parseListening(text);
    if (!address)
        return address.error();
    const Result<remote::Identity> identity = remote::identityFor(*address, bundle_, remote::Role::coordinator);
    if (!identity)
        return identity.error();
    auto listener = std::make_unique<remote::Listener>(*identity);
    if (const Result<void> listens = listener->listen(*address); !listens)
        return listens.error();
    connect(listener.get(), &remote::Listener::connected, this, &NodeConnections::accepted);
    connect(listener.get(), &remote::Listener::turnedAway, this, &NodeConnections::turnedAway);
    listener_ = std::move(listener);
    return listener_->address();
}

void NodeConnections::stopListening() {
    listener_.reset();
}

void NodeConnections::close() {
    closing_ = true;
    stopListening();
    if (nodes_.empty())
        emit empty();
    std::vector<NodeId> all;
    for (const auto& node : nodes_)
        all.push_back(node->status.id);
    for (const NodeId id : all)
        remove(id);
}

void NodeConnections::pump() {
    pumpIsDue_ = false;
    for (const auto& node : nodes_)
        if (node->link)
            node->link->pump();
}

std::vector<NodeStatus> NodeConnections::nodes() const {
    std::vector<NodeStatus> all;
    for (const auto& node : nodes_)
        all.push_back(statusOf(*node));
    return all;
}

void NodeConnections::tell() {
    const std::vector<NodeStatus> all = nodes();
    if (all.empty()) {
        telling_.stop();
        tick_.stop();
    }
    emit changed(all);
}

}  // namespace pdr::nodes
