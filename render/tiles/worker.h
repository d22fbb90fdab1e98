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
    /// Adds a result of that cost that arrived `seconds` after its lease was given out or after the previous result,
    /// whichever is later.
    void add(double cost, double seconds);
    bool isKnown() const { return cost_ > 0; }
    double perSecond() const { return isKnown() ? cost_ / seconds_ : 0; }  ///< 0: unknown

  private:
    static constexpr double kKept = 0.8;              ///< weight of the past, per result
    static constexpr double kShortestSeconds = 1e-4;  ///< shorter times are raised to this

    double cost_ = 0, seconds_ = 0;
};

/// Decides which results of a worker are audited: the own device renders them again and compares them bit by bit, the
/// first kFirst results whole, later an unpredictable part of some. A worker whose every result is wrong is detected at
/// the first one; a worker that falsifies one cell in 100 results is detected within 34,500 results with a
/// probability of 99.9 %.
class Trust {
  public:
    explicit Trust(std::uint64_t seed) : random_(seed) {}

    /// Whether each result is audited as a whole before it is merged.
    bool isOnProbation() const { return passed_ < kFirst; }
    /// Draws the part of the next result to audit after probation, in whole cells, or none. Each cell is audited with
    /// probability 1 / kOneIn.
    std::optional<Tile> partToAudit(const Tile& tile);
    /// Counts an audit that found no difference.
    void passed() { ++passed_; }

    static constexpr std::uint64_t kFirst = 64;  ///< number of results on probation
    static constexpr int kOneIn = 50;            ///< one of so many cells of later results is audited

  private:
    std::uint64_t passed_ = 0;
    std::mt19937_64 random_;
};

enum class WorkerState {
    waiting,     ///< has no scene yet, or cannot load it
    ready,       ///< has a scene
    suspect,     ///< silent for some time
    paused,      ///< paused by the user
    draining,    ///< finishes its leases, takes no new ones
    quarantined  ///< has sent a wrong result
};

/// Status of a worker, for display.
struct WorkerStatus {
    WorkerId id = kOwnDevice;
    std::string key, name;
    bool isDeep = false;  ///< takes leases of several blocks
    WorkerState state = WorkerState::waiting;
    Text reason;                ///< reason for the quarantine, or why the worker has no scene; empty: none
    double workPerSecond = 0;   ///< speed for pixels of average cost; 0: not known yet
    double work = 0;            ///< work of all merged results
    double busySeconds = 0;     ///< time spent on samples, as the worker reports it
    std::uint64_t results = 0;  ///< number of merged results
    std::uint64_t audited = 0;  ///< number of audits that found no difference
    std::uint64_t late = 0;     ///< number of results that arrived too late to be used
    std::uint64_t overdue = 0;  ///< number of portions that were taken back from the worker
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
    std::uint64_t scene = 0;  ///< number of the scene that it has loaded; 0: none
    bool isSuspect = false, isPaused = false, isDraining = false;
    double lastResult = 0;  ///< time of its last result, or of its first lease after idling [s]
    int inFlight = 0;       ///< leases that it has not answered, also of requests that have ended without it

    bool takesWork(std::uint64_t wantedScene) const {
        return scene == wantedScene && wantedScene != 0 && !isSuspect && !isPaused && !isDraining && !isQuarantined();
    }
    /// Returns the status, including the current speed.
    WorkerStatus statusNow() const;
    /// Counts a merged result.
    void count(const Portion& portion);
    bool isQuarantined() const { return status.state == WorkerState::quarantined; }
    /// Derives status.state from the flags, except in quarantine, which is permanent.
    void updateState();
};

}  // namespace pdr
