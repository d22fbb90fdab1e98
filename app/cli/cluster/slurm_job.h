#pragma once
/// Slurm jobs, submitted with Slurm's own programs.

#include "app/cli/cluster/cluster_options.h"
#include "app/remote/address.h"

namespace pdr::app {

/// Submits installer/slurm/pdrender-node.sbatch, which is embedded in this program, for nodes that dial `coordinator`.
/// Returns the job's number. Errors: sbatch cannot be started, and those that it reports.
Result<QString> submitNodes(const ClusterOptions& options, const remote::Address& coordinator);

}  // namespace pdr::app
