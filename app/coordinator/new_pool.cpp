#include "app/coordinator/new_pool.h"

#include <random>

namespace pdr::nodes {

std::shared_ptr<WorkerPool> newPool() {
    std::random_device random;
    const std::uint64_t high = random(), low = random();
    return std::make_shared<WorkerPool>(high << 32 | low);
}

}  // namespace pdr::nodes
