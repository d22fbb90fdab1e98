#include "app/presenters/node_figures.h"

#include <algorithm>

#include "ui/text/room_text.h"

namespace pdr::app {
namespace {

ui::NodeState stateOf(nodes::NodeState state, bool rendering) {
    switch (state) {
        case nodes::NodeState::dialling:
            return ui::NodeState::dialling;
        case nodes::NodeState::greeting:
            return ui::NodeState::connecting;
        case nodes::NodeState::waiting:
            return ui::NodeState::waiting;
        case nodes::NodeState::sending:
            return ui::NodeState::sendingScan;
        case nodes::NodeState::ready:
            return rendering ? ui::NodeState::rendering : ui::NodeState::ready;
        case nodes::NodeState::suspect:
            return ui::NodeState::suspect;
        case nodes::NodeState::paused:
            return ui::NodeState::paused;
        case nodes::NodeState::draining:
            return ui::NodeState::draining;
        case nodes::NodeState::lost:
            return ui::NodeState::lost;
        case nodes::NodeState::quarantined:
        case nodes::NodeState::refused:
            break;
    }
    return ui::NodeState::refused;
}

}  // namespace

void NodeFigures::follow(const std::vector<nodes::NodeStatus>& nodes, const ImageInHand& image, double now) {
    // Begin another image
    const bool another = image.revision != image_.revision || image.purpose != image_.purpose;
    const bool windowEnds = now - windowBegan_ >= kWindow;
    if (another)
        ownWorkAtImage_ = image.ownWork;
    image_ = image;
    workOfImage_ = image.ownWork - ownWorkAtImage_;
    // Update the counters of every node
    QHash<nodes::NodeId, Followed> followed;
    for (const nodes::NodeStatus& node : nodes) {
        const Count count{node.work.work, node.work.busySeconds};
        Followed one = nodes_.value(node.id, {.now = count, .atWindow = count});
        if (count.work < one.now.work)  // the node has reconnected, and its counters have restarted
            one = {};
        if (another)
            one.atImage = one.now;
        one.now = count;
        if (windowEnds) {
            one.efficiency =
                std::clamp((count.busySeconds - one.atWindow.busySeconds) / (now - windowBegan_), 0.0, 1.0);
            one.rendering = count.work > one.atWindow.work;
            one.atWindow = count;
        }
        workOfImage_ += one.now.work - one.atImage.work;
        followed[node.id] = one;
    }
    nodes_ = std::move(followed);
    if (windowEnds)
        windowBegan_ = now;
}

ui::NodeRow NodeFigures::rowOf(const nodes::NodeStatus& node) const {
    const Followed followed = nodes_.value(node.id);
    ui::NodeRow row;
    row.address = node.address;
    row.name = node.name;
    row.device = node.device;
    row.state = stateOf(node.state, followed.rendering);
    row.reason = ui::inWords(node.reason);
    row.scanSent = node.sent;
    row.dialledIn = !node.dialled;
    row.sameBits = !node.otherBits;
    row.latencyMs = node.latencyMs.value_or(-1);
    row.bytesSent = quint64(node.bytesOut);
    row.bytesReceived = quint64(node.bytesIn);
    row.faults = {int(node.losses), int(node.work.overdue)};
    if (row.state == ui::NodeState::rendering) {
        row.efficiency = followed.efficiency;
        row.iterationsPerSecond = image_.pixels > 0 ? node.work.workPerSecond / image_.pixels : 0;
    }
    if (workOfImage_ > 0)
        row.share = (followed.now.work - followed.atImage.work) / workOfImage_;
    return row;
}

}  // namespace pdr::app
