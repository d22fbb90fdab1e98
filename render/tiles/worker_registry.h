#pragma once
/// The connected workers, and what is remembered of a worker's key for good: its trust, and its quarantine. Not
/// thread-safe: see pool_state.h.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "render/tiles/worker.h"

namespace pdr {

class WorkerRegistry {
  public:
    /// `seed`: for choosing audits, which workers must not be able to predict.
    explicit WorkerRegistry(std::uint64_t seed) : seed_(seed) {}

    /// Adds a worker, with the trust and the quarantine of its key.
    WorkerId join(const std::string& key, const std::string& name);
    void leave(WorkerId worker);
    /// Returns the worker; null: it has left.
    Worker* find(WorkerId worker);
    const Worker* find(WorkerId worker) const;
    const std::map<WorkerId, Worker>& all() const { return workers_; }

    /// Quarantines all workers of that key, those that join later included. Returns the connected ones.
    std::vector<WorkerId> quarantine(const std::string& key, const Text& reason);
    /// Whether one of these keys was quarantined.
    bool isAnyUntrusted(const std::set<std::string>& keys) const;
    /// Whether there is a worker that is not quarantined.
    bool hasTrusted() const;

    /// Number of workers that take leases of that scene.
    int countTaking(std::uint64_t scene) const;
    /// Sum of the known speeds of these workers [cost/s].
    double perSecond(std::uint64_t scene) const;

  private:
    std::uint64_t seed_;
    WorkerId next_ = 1;
    std::map<WorkerId, Worker> workers_;
    std::map<std::string, Trust> past_;      ///< trust of workers that have left, by key
    std::map<std::string, Text> untrusted_;  ///< reason for the quarantine, by key
};

}  // namespace pdr
