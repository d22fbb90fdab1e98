#include "app/cli/nodes/node_messages.h"

namespace pdr::app {
namespace {

using nodes::NodeState;
using nodes::NodeStatus;

QString calledBy(const NodeStatus& node) {
    return node.name.isEmpty() ? node.address : node.name;
}

QString reasonOf(const NodeStatus& node) {
    return QString::fromStdString(node.reason);
}

bool isHelpless(const NodeStatus& node) {
    const bool lacksScene = node.state == NodeState::ready && !node.reason.empty();
    return lacksScene || node.state == NodeState::refused || node.state == NodeState::quarantined;
}

}  // namespace

QStringList NodeMessages::follow(const std::vector<NodeStatus>& nodes) {
    QStringList lines;
    helpless_ = 0;
    for (const NodeStatus& node : nodes) {
        helpless_ += node.dialled && isHelpless(node);
        const bool worked = node.work.id != kOwnDevice;
        if (node.dialled || worked) {
            Part& part = parts_[node.id];
            const QString name = node.name.isEmpty() ? part.last.name : node.name;
            part.last = node;
            part.last.name = name;
            if (worked)
                part.work[node.work.id] = node.work;
        }
        if (told_.record(node))
            lines << QString("node %1: %2").arg(calledBy(node), reasonOf(node));
    }
    return lines;
}

QString NodeMessages::gone(const NodeStatus& node) {
    told_.record(node);
    return QString(node.saidGoodbye ? "node %1 has left: %2" : "node %1 is lost: %2")
        .arg(calledBy(node), reasonOf(node));
}

QString NodeMessages::turnedAway(const QString& peer, const QString& reason) {
    const QString host = peer.section(':', 0, -2);
    return told_.record(host, reason) ? QString("%1 was turned away: %2").arg(host, reason) : QString();
}

QStringList NodeMessages::report(const std::vector<WorkerStatus>& workers, double ownWork) const {
    // Take the latest counters of connections that still exist, and sum all work
    std::map<nodes::NodeId, Part> parts = parts_;
    double all = ownWork;
    for (auto& [id, part] : parts)
        for (auto& [connection, work] : part.work) {
            for (const WorkerStatus& worker : workers)
                if (worker.id == connection)
                    work = worker;
            all += work.work;
        }
    QStringList lines;
    // Write one line for each node
    for (const auto& [id, part] : parts) {
        WorkerStatus sum;
        for (const auto& [connection, work] : part.work) {
            sum.work += work.work;
            sum.results += work.results;
            sum.audited += work.audited;
        }
        const QString reason = part.last.reason.empty() ? QString() : "; " + reasonOf(part.last);
        if (part.work.empty())
            lines << QString("node %1: took no part%2").arg(calledBy(part.last), reason);
        else
            lines << QString("node %1: %2 % of the samples, %3 tiles, %4 checked%5")
                         .arg(calledBy(part.last))
                         .arg(all > 0 ? 100 * sum.work / all : 0, 0, 'f', 1)
                         .arg(sum.results)
                         .arg(sum.audited)
                         .arg(reason);
    }
    return lines;
}

}  // namespace pdr::app
