#include "app/coordinator/told_reasons.h"

namespace pdr::nodes {
namespace {

/// Returns the key that identifies a node across connections: its address if it was dialled; its name if it dialled,
/// because its port differs each time.
QString keyOf(const NodeStatus& node) {
    return node.dialled ? node.address : node.name;
}

}  // namespace

bool ToldReasons::record(const NodeStatus& node) {
    return !node.reason.empty() && record(keyOf(node), QString::fromStdString(node.reason));
}

bool ToldReasons::record(const QString& who, const QString& reason) {
    return told_.size() < kMost && told_.insert({who, reason}).second;
}

}  // namespace pdr::nodes
