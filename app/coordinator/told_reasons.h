#pragma once
/// Reasons why render nodes do not help, as far as they were told: logs and terminals tell each once.

#include <QString>
#include <set>
#include <utility>

#include "app/coordinator/node_status.h"

namespace pdr::nodes {

class ToldReasons {
  public:
    /// Records that the reason of a node was told. False: it has none, or was told before, perhaps on an earlier
    /// connection.
    bool record(const NodeStatus& node);
    /// Records that a reason of a host or a node was told. False: it was told before.
    bool record(const QString& who, const QString& reason);

    /// Largest number of reasons that are told. It is limited because a node that dials chooses its own name.
    static constexpr std::size_t kMost = 1000;

  private:
    std::set<std::pair<QString, QString>> told_;  ///< node or host, and its reason
};

}  // namespace pdr::nodes
