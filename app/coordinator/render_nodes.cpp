#include "app/coordinator/render_nodes.h"

#include <utility>

#include "app/coordinator/node_connections.h"
#include "app/coordinator/reference_bits.h"

namespace pdr::nodes {
namespace {

constexpr unsigned long kFarewellMs = 1000;

/// Calls `ask` in the thread of `desk`, waits for it, and returns its result.
template <class Ask>
auto in(NodeConnections* desk, Ask&& ask) {
    using Answer = decltype(ask());
    std::optional<Answer> answer;
    QMetaObject::invokeMethod(
        desk, [&] { answer.emplace(ask()); }, Qt::BlockingQueuedConnection);
    return *std::move(answer);
}

}  // namespace

RenderNodes::RenderNodes(std::shared_ptr<LeaseServer> leases, const std::vector<std::byte>& bits, QObject* parent)
    : QObject(parent), leases_(std::move(leases)), desk_(new NodeConnections(leases_, bitsOf(bits))) {
    qRegisterMetaType<NodeStatus>();
    qRegisterMetaType<std::vector<NodeStatus>>();
    desk_->moveToThread(&thread_);
    connect(desk_, &NodeConnections::changed, this, [this](const std::vector<NodeStatus>& nodes) {
        nodes_ = nodes;
        emit changed();
    });
    // Direct connections: the thread that owns this object may be too busy to pass signals on.
    connect(desk_, &NodeConnections::joined, this, &RenderNodes::joined, Qt::DirectConnection);
    connect(desk_, &NodeConnections::lost, this, &RenderNodes::lost, Qt::DirectConnection);
    connect(desk_, &NodeConnections::changed, this, &RenderNodes::seen, Qt::DirectConnection);
    connect(desk_, &NodeConnections::turnedAway, this, &RenderNodes::turnedAway, Qt::DirectConnection);
    connect(&thread_, &QThread::finished, desk_, &QObject::deleteLater);
    connect(desk_, &NodeConnections::empty, &thread_, &QThread::quit, Qt::DirectConnection);
    thread_.setObjectName("nodes");
    thread_.start();
}

RenderNodes::~RenderNodes() {
    QMetaObject::invokeMethod(desk_, &NodeConnections::close, Qt::QueuedConnection);
    if (!thread_.wait(kFarewellMs)) {
        thread_.quit();
        thread_.wait();
    }
}

void RenderNodes::setBundle(const QString& folder) {
    QMetaObject::invokeMethod(desk_, [desk = desk_, folder] { desk->setBundle(folder); });
}

Result<NodeId> RenderNodes::add(const QString& address) {
    return in(desk_, [&] { return desk_->add(address); });
}

std::vector<NodeStatus> RenderNodes::look() const {
    return in(desk_, [&] { return desk_->nodes(); });
}

void RenderNodes::remove(NodeId node) {
    QMetaObject::invokeMethod(desk_, [desk = desk_, node] { desk->remove(node); });
}

void RenderNodes::setPaused(NodeId node, bool paused) {
    QMetaObject::invokeMethod(desk_, [desk = desk_, node, paused] { desk->setPaused(node, paused); });
}

Result<remote::Address> RenderNodes::listen(const QString& address) {
    return in(desk_, [&] { return desk_->listen(address); });
}

void RenderNodes::stopListening() {
    QMetaObject::invokeMethod(desk_, [desk = desk_] { desk->stopListening(); });
}

}  // namespace pdr::nodes
