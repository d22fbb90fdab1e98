#pragma once
/// Command `pdrender-cli cluster`: starts render nodes as a job on a cluster that Slurm schedules.

#include <QStringList>

namespace pdr::app {

/// Runs the command with `arguments`, those after the word "cluster". Returns the exit code: 0 if all nodes are
/// connected, 1 on an error or if not all nodes come in time, 2 on wrong usage.
int runCluster(const QStringList& arguments);

}  // namespace pdr::app
