#pragma once
/// Jobs of Slurm, by its own programs.

#include "app/cli/cluster_options.h"
#include "app/remote/address.h"

namespace pdr::app {

/// Submits installer/slurm/pdrender-node.sbatch, which this program carries inside it, for nodes that dial
/// `coordinator`; returns the job's number. Errors: no sbatch here, and what it says.
Result<QString> submitNodes(const ClusterOptions& options, const remote::Address& coordinator);

}  // namespace pdr::app
