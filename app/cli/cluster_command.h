#pragma once
/// pdrender-cli cluster: starts render nodes on machines that others hand out.

#include <QStringList>

namespace pdr::app {

/// `arguments` behind the word "cluster". Returns the exit code: 0 all nodes are there, 1 an error, or not all came in
/// time, 2 wrong usage.
int runCluster(const QStringList& arguments);

}  // namespace pdr::app
