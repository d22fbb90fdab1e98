#pragma once
/// Messages about render nodes for a terminal: changes, each reported once, and in the end what each node has done.

#include <QStringList>
#include <map>
#include <vector>

#include "app/coordinator/told_reasons.h"

namespace pdr::app {

class NodeMessages {
  public:
    /// Returns the reasons, as far as not reported before, why nodes do not help now: "node 192.0.2.7:4743: there is no
    /// connection: ...". `nodes`: all current nodes.
    QStringList follow(const std::vector<nodes::NodeStatus>& nodes);
    /// Returns the line for a node that took part and is gone. Its reason counts as reported.
    QString gone(const nodes::NodeStatus& node);
    /// Returns the line for a program that was rejected before it identified itself; empty if the same was already
    /// reported of its machine.
    QString turnedAway(const QString& peer, const QString& reason);

    /// Returns the number of dialled nodes that will not help any more: refused, quarantined, or unable to take the
    /// scene.
    int helpless() const { return helpless_; }
    /// Returns one line for each node that was dialled or took part, summed over all its connections. `workers`: the
    /// current ones. `ownWork`: the work of this machine [pixels times samples].
    QStringList report(const std::vector<WorkerStatus>& workers, double ownWork) const;

  private:
    struct Part {
        nodes::NodeStatus last;
        std::map<WorkerId, WorkerStatus> work;  ///< counters of each connection
    };

    std::map<nodes::NodeId, Part> parts_;
    nodes::ToldReasons told_;
    int helpless_ = 0;
};

}  // namespace pdr::app
