#include "app/presenters/node_events.h"

#include <QCoreApplication>

#include "ui/nodes/node_text.h"

namespace pdr::app {
namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("nodeEvents", text);
}

bool takesPart(const ui::NodeRow& node) {
    return node.state == ui::NodeState::ready || node.state == ui::NodeState::rendering ||
           node.state == ui::NodeState::suspect;
}

QString calledBy(const ui::NodeRow& node) {
    return node.name.isEmpty() ? node.address : node.name;
}

QString goneText(const ui::NodeRow& node) {
    const QString name = calledBy(node);
    switch (node.state) {
        case ui::NodeState::paused:
            return translated("%1 was paused").arg(name);
        case ui::NodeState::draining:
            return translated("%1 leaves").arg(name);
        case ui::NodeState::waiting:
            return translated("%1 works for others").arg(name);
        case ui::NodeState::sendingScan:
            return translated("%1 waits for the scan").arg(name);
        default:
            break;
    }
    return node.reason.isEmpty() ? translated("%1 was lost").arg(name)
                                 : translated("%1 was lost: %2").arg(name, node.reason);
}

}  // namespace

void NodeEvents::follow(const QList<ui::NodeRow>& nodes, std::uint64_t image, double seconds) {
    if (image != image_)
        events_.clear();
    image_ = image;
    QHash<quint64, ui::NodeRow> gone = takingPart_;
    for (const ui::NodeRow& node : nodes) {
        if (takesPart(node)) {
            if (!takingPart_.contains(node.id))
                add(seconds, translated("%1 joined").arg(calledBy(node)), true);
            takingPart_[node.id] = node;
            gone.remove(node.id);
        } else if (gone.remove(node.id) > 0) {
            takingPart_.remove(node.id);
            add(seconds, goneText(node), false);
        }
    }
    for (const ui::NodeRow& node : gone) {
        takingPart_.remove(node.id);
        add(seconds, translated("%1 was removed").arg(calledBy(node)), false);
    }
}

void NodeEvents::add(double seconds, const QString& text, bool joined) {
    if (events_.size() == kMost)
        events_.erase(events_.begin());
    events_.push_back({seconds, text, joined});
}

}  // namespace pdr::app
