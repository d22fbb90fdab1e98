#pragma once
/// A worker's state: its speed, its trust and the leases that it owes.
///   work   pixels times samples
///   cost   work, weighted by the cost of the cells (cell_costs.h)

#include <cstdint>
#include <optional>
#include <random>
#include <string>

#include "render/base/text.h"
#include "render/tiles/lease.h"

namespace pdr {

/// Cost per second, an exponentially weighted average over results.
class WorkerSpeed {
  public:
    /// A result of that cost arrived `seconds` after its lease was given out or after the previous result, whichever is
    /// later.
    void add(double cost, double seconds);
    bool isKnown() const { return cost_ > 0; }
    double perSecond() const { return isKnown() ? cost_ / seconds_ : 0; }

  private:
    static constexpr double kKept = 0.8;              ///< weight of the past, per result
    static constexpr double kShortestSeconds = 1e-4;  ///< shorter times are raised to this

    double cost_ = 0, seconds_ = 0;
};

/// Audits: the own device renders results again and compares them bit by bit; the first kFirst whole, later an
/// unpredictable part of some. A worker whose every result is wrong is found at the first one; one that falsifies one
/// cell in 100 results is found within 34,500 results with a probability of 99.9 %.
class Trust {
  public:
    explicit Trust(std::uint64_t seed) : random_(seed) {}

    /// Each result is audited as a whole before it is merged.
    bool isOnProbation() const { return passed_ < kFirst; }
    /// After probation: the part of the next result to audit, in whole cells, or none. Each cell is audited with
    /// probability 1 / kOneIn.
    std::optional<Tile> partToAudit(const Tile& tile);
    void passed() { ++passed_; }

    static constexpr std::uint64_t kFirst = 64;  ///< results on probation
    static constexpr int kOneIn = 50;            ///< cells of later results

  private:
    std::uint64_t passed_ = 0;
    std::mt19937_64 random_;
};

enum class WorkerState {
    waiting,     ///< for the scene
    ready,       ///< has a scene
    suspect,     ///< silent for some time
    paused,      ///< by the user
    draining,    ///< finishes its leases, takes no new ones
    quarantined  ///< has sent a wrong result
};

/// What is shown of a worker.
struct WorkerStatus {
    WorkerId id = kOwnDevice;
    std::string key, name;
    WorkerState state = WorkerState::waiting;
    Text reason;                ///< for the quarantine, or why it has no scene
    double workPerSecond = 0;   ///< for pixels of average cost; 0: not known yet
    double work = 0;            ///< of all merged results
    double busySeconds = 0;     ///< time on samples, as it reports
    std::uint64_t results = 0;  ///< merged
    std::uint64_t audited = 0;  ///< of them, audited and found right
    std::uint64_t late = 0;     ///< results that came too late to be of use
    std::uint64_t overdue = 0;  ///< portions that were taken back from it
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
    std::uint64_t scene = 0;  ///< that it has loaded; 0: none
    bool isSuspect = false, isPaused = false, isDraining = false;
    double lastResult = 0;  ///< seconds
    int inFlight = 0;       ///< leases that it has not answered, also of orders that have ended without it

    bool takesWork(std::uint64_t wantedScene) const {
        return scene == wantedScene && wantedScene != 0 && !isSuspect && !isPaused && !isDraining && !isQuarantined();
    }
    /// A result of it was merged.
    void count(const Portion& portion);
    bool isQuarantined() const { return status.state == WorkerState::quarantined; }
    void updateState();
};

}  // namespace pdr
