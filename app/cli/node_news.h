#pragma once
/// News of render nodes for a person who reads lines: what is to be said of them, each thing once, and what each has
/// done in the end.

#include <QStringList>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "app/coordinator/node_status.h"

namespace pdr::app {

class NodeNews {
  public:
    /// The reasons, not said before, why nodes do not help now: "node 192.0.2.7:4743: there is no connection: ...".
    /// `nodes`: all that there are now.
    QStringList follow(const std::vector<nodes::NodeStatus>& nodes);
    /// The line for a node that took part and is gone. Its reason counts as said.
    QString gone(const nodes::NodeStatus& node);
    /// The line for a program that was sent away before it had said what it is; empty: it was said of that machine.
    QString turnedAway(const QString& peer, const QString& reason);

    /// Nodes that were dialled and will not help any more: refused, quarantined, or unable to take the scene.
    int helpless() const { return helpless_; }
    /// One line for each node that was dialled or took part, over all its connections. `workers`: those of now.
    /// `ownWork`: of this machine, in pixels times samples.
    QStringList report(const std::vector<WorkerStatus>& workers, double ownWork) const;

    /// Lines, beyond which no further reasons are said: who dials chooses its name.
    static constexpr std::size_t kMostReasons = 1000;

  private:
    struct Part {
        nodes::NodeStatus last;
        std::map<WorkerId, WorkerStatus> work;  ///< of each connection
    };

    bool isNew(const QString& who, const QString& reason);

    std::map<nodes::NodeId, Part> parts_;
    std::set<std::pair<QString, QString>> said_;  ///< who, reason
    int helpless_ = 0;
};

}  // namespace pdr::app
