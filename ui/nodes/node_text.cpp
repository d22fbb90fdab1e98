#include "ui/nodes/node_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

#include "ui/text/language.h"

namespace pdr::ui {
namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("nodeText", text);
}

QString stateWord(const NodeRow& node) {
    switch (node.state) {
        case NodeState::dialling:
            return translated("Dialling");
        case NodeState::connecting:
            return translated("Connecting");
        case NodeState::waiting:
            return translated("Waiting");
        case NodeState::sendingScan:
            return translated("Sending the scan, %1 %").arg(number(100 * node.scanSent, 0));
        case NodeState::ready:
            return translated("Ready");
        case NodeState::rendering:
            return translated("Rendering");
        case NodeState::suspect:
            return translated("Silent");
        case NodeState::paused:
            return translated("Paused");
        case NodeState::draining:
            return translated("Leaving");
        case NodeState::lost:
            return translated("Lost");
        case NodeState::refused:
            break;
    }
    return translated("Refused");
}

bool asksForALook(NodeState state) {
    return state == NodeState::suspect || state == NodeState::lost || state == NodeState::refused;
}

/// Returns whether the node has reported its device.
bool isKnown(const NodeRow& node) {
    return !node.device.isEmpty();
}

}  // namespace

QString nodeName(const NodeRow& node) {
    return node.name.isEmpty() ? node.address : QString("%1 (%2)").arg(node.name, node.address);
}

QString nodeStateText(const NodeRow& node) {
    const QString mark = asksForALook(node.state) ? QString::fromUtf8("\u26A0 ") : QString();
    return mark + stateWord(node) + (node.reason.isEmpty() ? QString() : ": " + node.reason);
}

QString bytesText(quint64 bytes) {
    return bytes == 0 ? QString() : QLocale().formattedDataSize(qint64(bytes), 1, QLocale::DataSizeSIFormat);
}

QString faultsText(const NodeFaults& faults) {
    QStringList texts;
    const auto add = [&](int count, const char* text) {
        if (count > 0)
            texts << translated(text).arg(count);
    };
    add(faults.lost, QT_TRANSLATE_NOOP("nodeText", "connections lost: %1"));
    add(faults.overdue, QT_TRANSLATE_NOOP("nodeText", "results that never came: %1"));
    return texts.join(", ");
}

QString nodeSentence(const NodeRow& node) {
    QStringList parts{nodeName(node), nodeStateText(node)};
    if (isKnown(node))
        parts << node.device;
    if (node.iterationsPerSecond > 0)
        parts << translated("%1 iterations/s").arg(number(node.iterationsPerSecond, 2));
    if (node.share > 0)
        parts << translated("%1 % of the image's samples").arg(number(100 * node.share, 0));
    if (const QString faults = faultsText(node.faults); !faults.isEmpty())
        parts << faults;
    return parts.join(", ");
}

QString bitsText(const QList<NodeRow>& nodes) {
    const auto known = std::ranges::count_if(nodes, isKnown);
    const auto others = std::ranges::count_if(nodes, [](const NodeRow& node) { return !node.sameBits; });
    if (known == 0)
        return {};
    if (others == 0)
        return translated("All nodes compute the same bits as this machine");
    if (others == 1)
        return translated("1 node runs a different build and was excluded");
    return translated("%1 nodes run a different build and were excluded").arg(others);
}

}  // namespace pdr::ui
