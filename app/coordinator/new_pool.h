#pragma once
/// The pool of a coordinator's nodes.

#include <memory>

#include "render/tiles/worker_pool.h"

namespace pdr::nodes {

/// Returns an empty pool with a random choice of audits, which nodes cannot predict.
std::shared_ptr<WorkerPool> newPool();

}  // namespace pdr::nodes
