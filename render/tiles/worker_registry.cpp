#include "render/tiles/worker_registry.h"

#include <algorithm>
#include <utility>

namespace pdr {
namespace {

void setQuarantine(Worker& worker, const Text& reason) {
    if (worker.isQuarantined())
        return;
    worker.status.state = WorkerState::quarantined;
    worker.status.reason = reason;
}

}  // namespace

WorkerId WorkerRegistry::join(const std::string& key, const std::string& name) {
    const WorkerId id = next_++;
    Worker& worker = workers_.emplace(id, Worker(id, key, name, seed_ + id)).first->second;
    if (const auto past = past_.extract(key))
        worker.trust = past.mapped();
    if (const auto untrusted = untrusted_.find(key); untrusted != untrusted_.end())
        setQuarantine(worker, untrusted->second);
    return id;
}

void WorkerRegistry::leave(WorkerId id) {
    const auto found = workers_.find(id);
    if (found == workers_.end())
        return;
    past_.insert_or_assign(found->second.status.key, found->second.trust);
    workers_.erase(found);
}

Worker* WorkerRegistry::find(WorkerId id) {
    const auto found = workers_.find(id);
    return found == workers_.end() ? nullptr : &found->second;
}

const Worker* WorkerRegistry::find(WorkerId id) const {
    const auto found = workers_.find(id);
    return found == workers_.end() ? nullptr : &found->second;
}

std::vector<WorkerId> WorkerRegistry::quarantine(const std::string& key, const Text& reason) {
    untrusted_.emplace(key, reason);
    std::vector<WorkerId> connected;
    for (auto& [id, worker] : workers_)
        if (worker.status.key == key) {
            setQuarantine(worker, reason);
            connected.push_back(id);
        }
    return connected;
}

bool WorkerRegistry::isAnyUntrusted(const std::set<std::string>& keys) const {
    return std::ranges::any_of(keys, [&](const std::string& key) { return untrusted_.contains(key); });
}

bool WorkerRegistry::hasTrusted() const {
    return std::ranges::any_of(workers_, [](const auto& one) { return !one.second.isQuarantined(); });
}

int WorkerRegistry::countTaking(std::uint64_t scene) const {
    return int(std::ranges::count_if(workers_, [&](const auto& one) { return one.second.takesWork(scene); }));
}

double WorkerRegistry::perSecond(std::uint64_t scene) const {
    double sum = 0;
    for (const auto& [id, worker] : workers_)
        if (worker.takesWork(scene))
            sum += worker.speed.perSecond();
    return sum;
}

}  // namespace pdr
