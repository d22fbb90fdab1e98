#include "app/presenters/desktop_nodes.h"

#include <algorithm>
#include <utility>

#include "app/coordinator/new_pool.h"
#include "app/remote/address.h"
#include "ui/text/room_text.h"

namespace pdr::app {
namespace {

/// Added to the ids of nodes that dialled in; the ids of requested nodes are smaller.
constexpr quint64 kDialledIn = quint64(1) << 32;

QString sentenceOf(const Error& error) {
    return ui::sentence(error.text());
}

}  // namespace

DesktopNodes::DesktopNodes(RenderBridge& bridge) : bridge_(bridge) {
    clock_.start();
    connect(&bridge_.devices(), &DeviceChoice::sharedWith, this, &DesktopNodes::takeBits);
    connect(&bridge_, &RenderBridge::frameReady, this, [this] {
        if (nodes_)
            follow();
    });
}

/// Destroys the nodes first: they still answer requests of the pool.
DesktopNodes::~DesktopNodes() {
    nodes_.reset();
}

QStringList DesktopNodes::addresses() const {
    QStringList addresses;
    for (const Wanted& one : wanted_)
        addresses << one.address;
    return addresses;
}

QString DesktopNodes::splitText() const {
    const bool any = std::ranges::any_of(rows_, [](const ui::NodeRow& row) {
        return row.state == ui::NodeState::ready || row.state == ui::NodeState::rendering;
    });
    if (!any)
        return {};
    const SplitChoice choice = pool_->split();
    const QString reason = ui::inWords(choice.reason);
    if (reason.isEmpty())  // no work has been split yet
        return {};
    const QString how = choice.split == Split::tiles ? tr("Tiles: %1").arg(reason) : tr("Samples: %1").arg(reason);
    return pool_->scene().purpose == Purpose::finalRender ? tr("For the image that is being saved. %1").arg(how) : how;
}

QString DesktopNodes::checksText() const {
    return pool_ ? ui::inWords(pdr::checksText(pool_->checks())) : QString();
}

void DesktopNodes::add(const QString& address) {
    if (addresses().contains(address))
        return emit failed(tr("%1 is in the list already.").arg(address));
    wanted_.push_back({nextId_++, address});
    beginOrEnd();
    if (nodes_)
        dial(wanted_.back());
    emit wantedChanged();
    follow();
}

void DesktopNodes::dial(Wanted& wanted) {
    const Result<nodes::NodeId> node = nodes_->add(wanted.address);
    if (!node) {
        wanted.problem = ui::inWords(node.error().what);
        return emit failed(sentenceOf(node.error()));
    }
    wanted.node = *node;
    wanted.problem.clear();
    if (wanted.paused)
        nodes_->setPaused(*node, true);
}

void DesktopNodes::remove(quint64 id) {
    if (id >= kDialledIn) {
        if (nodes_)
            nodes_->remove(nodes::NodeId(id - kDialledIn));
        return;
    }
    const auto found = std::ranges::find(wanted_, id, &Wanted::id);
    if (found == wanted_.end())
        return;
    if (found->node && nodes_)
        nodes_->remove(*found->node);
    wanted_.erase(found);
    beginOrEnd();
    emit wantedChanged();
    follow();
}

void DesktopNodes::setPaused(quint64 id, bool paused) {
    if (id >= kDialledIn) {
        if (nodes_)
            nodes_->setPaused(nodes::NodeId(id - kDialledIn), paused);
        return;
    }
    const auto found = std::ranges::find(wanted_, id, &Wanted::id);
    if (found == wanted_.end())
        return;
    found->paused = paused;
    if (found->node && nodes_)
        nodes_->setPaused(*found->node, paused);
}

void DesktopNodes::listen(const std::optional<quint16>& port) {
    port_ = port;
    beginOrEnd();
    if (nodes_)
        openPort();
    emit wantedChanged();
}

void DesktopNodes::openPort() {
    nodes_->stopListening();
    if (!port_)
        return;
    // Without certificates only programs on this machine may connect.
    const QString where = bundle_.isEmpty() ? QString("127.0.0.1:%1").arg(*port_) : QString::number(*port_);
    if (const Result<remote::Address> listens = nodes_->listen(where); !listens)
        emit failed(sentenceOf(listens.error()));
}

void DesktopNodes::setBundle(const QString& folder) {
    if (folder == bundle_)
        return;
    bundle_ = folder;
    if (nodes_) {
        nodes_->setBundle(folder);
        for (Wanted& one : wanted_)
            if (one.node)
                nodes_->remove(*std::exchange(one.node, std::nullopt));
        dialAll();
        openPort();
    }
    emit wantedChanged();
    follow();
}

void DesktopNodes::setSplit(const std::optional<Split>& split) {
    if (split == split_)
        return;
    split_ = split;
    if (pool_)
        pool_->setSplit(split_);
    emit wantedChanged();
}

void DesktopNodes::setChecksAll(bool all) {
    if (all == checksAll_)
        return;
    checksAll_ = all;
    if (pool_)
        pool_->setChecksAll(checksAll_);
    emit wantedChanged();
}

/// Shares the device with the first node or port that is requested, and ends sharing with the last.
void DesktopNodes::beginOrEnd() {
    const bool any = !wanted_.empty() || port_;
    if (any == (pool_ != nullptr))
        return;
    pool_ = any ? nodes::newPool() : nullptr;
    if (any) {
        pool_->setSplit(split_);
        pool_->setChecksAll(checksAll_);
    } else {
        nodes_.reset();
        bits_.clear();
    }
    bridge_.setPool(pool_);
}

/// Starts the nodes when the device has been shared, and restarts them when its bits differ: nodes must produce the
/// same bits as the device.
void DesktopNodes::takeBits(const std::vector<std::byte>& bits) {
    if (!pool_ || (nodes_ && bits == bits_))
        return;
    bits_ = bits;
    nodes_.reset();
    nodes_ = std::make_unique<nodes::RenderNodes>(pool_, bits_);
    connect(nodes_.get(), &nodes::RenderNodes::changed, this, &DesktopNodes::follow);
    nodes_->setBundle(bundle_);
    dialAll();
    openPort();
    follow();
}

void DesktopNodes::dialAll() {
    for (Wanted& one : wanted_) {
        one.node.reset();
        dial(one);
    }
}

const nodes::NodeStatus* DesktopNodes::statusOf(const Wanted& wanted) const {
    if (!wanted.node || !nodes_)
        return nullptr;
    const auto found = std::ranges::find(nodes_->nodes(), *wanted.node, &nodes::NodeStatus::id);
    return found == nodes_->nodes().end() ? nullptr : &*found;
}

/// Returns the image that the nodes are rendering. One that is being saved comes first.
ImageInHand DesktopNodes::imageInHand(const Frame& frame) const {
    const PublishedScene wanted = pool_ ? pool_->scene() : PublishedScene();
    const double ownWork = pool_ ? pool_->ownWork() : 0;
    if (wanted.purpose == Purpose::finalRender)
        return {wanted.number, double(wanted.scene->film.x) * wanted.scene->film.y, ownWork, wanted.purpose};
    return {frame.revision, frame.coarse ? 0 : double(frame.size.x) * frame.size.y, ownWork};
}

void DesktopNodes::follow() {
    const std::shared_ptr<const Frame>& frame = bridge_.lastFrame();
    static const std::vector<nodes::NodeStatus> kNone;
    const std::vector<nodes::NodeStatus>& all = nodes_ ? nodes_->nodes() : kNone;
    if (frame)
        figures_.follow(all, imageInHand(*frame), double(clock_.elapsed()) / 1000);
    rows_.clear();
    // Rows of the requested nodes
    for (const Wanted& one : wanted_) {
        const nodes::NodeStatus* status = statusOf(one);
        ui::NodeRow row = status ? figures_.rowOf(*status) : ui::NodeRow();
        row.id = one.id;
        row.address = one.address;
        if (!one.problem.isEmpty()) {
            row.state = ui::NodeState::refused;
            row.reason = one.problem;
        }
        rows_ << row;
    }
    // Rows of the nodes that dialled in
    for (const nodes::NodeStatus& status : all)
        if (!status.dialled) {
            rows_ << figures_.rowOf(status);
            rows_.back().id = kDialledIn + status.id;
        }
    if (frame && !frame->coarse)
        events_.follow(rows_, frame->revision, frame->seconds);
    emit changed();
}

}  // namespace pdr::app
