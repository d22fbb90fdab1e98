#include "render/tiles/worker_pool.h"

#include <chrono>
#include <utility>

#include "render/tiles/pool_state.h"

namespace pdr {

double poolSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

WorkerPool::WorkerPool(std::uint64_t seed, PoolClock clock)
    : WorkerPool(std::make_shared<PoolState>(seed, std::move(clock))) {}

WorkerPool::WorkerPool(const std::shared_ptr<PoolState>& state)
    : LeaseServer(state), SharedWork(state), state_(state) {}

void WorkerPool::setSplit(std::optional<Split> split) {
    const std::lock_guard lock(state_->mutex);
    state_->pinnedSplit = split;
}

SplitChoice WorkerPool::split() const {
    const std::lock_guard lock(state_->mutex);
    return state_->split;
}

void WorkerPool::setOwnHelps(bool helps) {
    const std::lock_guard lock(state_->mutex);
    state_->own.helps = helps;
}

void WorkerPool::setChecksAll(bool all) {
    const std::lock_guard lock(state_->mutex);
    state_->checksAll = all;
}

double WorkerPool::ownWork() const {
    const std::lock_guard lock(state_->mutex);
    return state_->own.work;
}

std::vector<WorkerStatus> WorkerPool::workers() const {
    const std::lock_guard lock(state_->mutex);
    std::vector<WorkerStatus> all;
    for (const auto& [id, worker] : state_->registry.all())
        all.push_back(worker.statusNow());
    return all;
}

}  // namespace pdr
