#pragma once
/// One who takes samples for a picture: how fast, and how far it is trusted.
///   work   pixels times samples
///   cost   the same, each worth what its cell costs (cell_costs.h)

#include <cstdint>
#include <optional>
#include <random>
#include <string>

#include "render/tiles/lease.h"

namespace pdr {

/// What cost it does in a second, as results come in: of the last ones most.
class WorkerSpeed {
  public:
    /// A result of that cost came so long after it was given out, or after the result before it.
    void add(double cost, double seconds);
    bool isKnown() const { return cost_ > 0; }
    double perSecond() const { return isKnown() ? cost_ / seconds_ : 0; }

  private:
    static constexpr double kKept = 0.8;              ///< of what was known, with each result
    static constexpr double kShortestSeconds = 1e-4;  ///< that is believed

    double cost_ = 0, seconds_ = 0;
};

/// Results are done again by the own device, and compared bit by bit: the first ones whole, later a part of some that
/// the worker cannot foresee. Who lies about all of them is found with the first, who lies about a cell of 1 in 100
/// after some 34,500 with a probability of 99.9 %.
class Trust {
  public:
    explicit Trust(std::uint64_t seed) : random_(seed) {}

    /// Its results are audited, each as a whole, and wait for that.
    bool isOnProbation() const { return passed_ < kFirst; }
    /// After that: the part of the next result that is audited, in whole cells; none. Each cell's chance is 1 in
    /// kOneIn.
    std::optional<Tile> partToAudit(const Tile& tile);
    void passed() { ++passed_; }

    static constexpr std::uint64_t kFirst = 64;  ///< results that are all audited
    static constexpr int kOneIn = 50;            ///< of the cells of those after

  private:
    std::uint64_t passed_ = 0;
    std::mt19937_64 random_;
};

enum class WorkerState {
    waiting,     ///< for the scene
    ready,       ///< takes samples, or would
    suspect,     ///< has not been heard of for some time
    paused,      ///< by the user
    draining,    ///< finishes what it has
    quarantined  ///< has sent what is not true
};

/// What the user is told of a worker.
struct WorkerStatus {
    WorkerId id = kOwnDevice;
    std::string key, name;
    WorkerState state = WorkerState::waiting;
    std::string reason;         ///< of its quarantine, or why it has no scene
    double workPerSecond = 0;   ///< where pixels cost as much as on average; 0: not known yet
    double work = 0;            ///< of results that were taken, in all
    double busySeconds = 0;     ///< that it says it has spent on them
    std::uint64_t results = 0;  ///< taken
    std::uint64_t audited = 0;  ///< of them, found true
    std::uint64_t late = 0;     ///< results that somebody else had brought before
    std::uint64_t overdue = 0;  ///< portions that it never brought
};

struct Worker {
    Worker(WorkerId id, std::string key, std::string name, std::uint64_t seed) : trust(seed) {
        status.id = id;
        status.key = std::move(key);
        status.name = std::move(name);
    }

    WorkerStatus status;
    WorkerSpeed speed;
    Trust trust;
    std::uint64_t scene = 0;  ///< that it has; 0: none
    bool isSuspect = false, isPaused = false, isDraining = false;
    double lastResult = 0;  ///< seconds
    int inFlight = 0;       ///< leases that it has not answered, also of orders that have ended without it

    bool takesWork(std::uint64_t wantedScene) const {
        return scene == wantedScene && wantedScene != 0 && !isSuspect && !isPaused && !isDraining && !isQuarantined();
    }
    /// A result of it was taken.
    void count(const Portion& portion);
    bool isQuarantined() const { return status.state == WorkerState::quarantined; }
    void updateState();
};

}  // namespace pdr
