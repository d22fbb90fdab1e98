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

/// How far a worker is trusted, and which of its results are audited: rendered again by another machine and compared
/// bit by bit.
///   stranger   no sample of it was confirmed yet: what it sends is withheld until the own device has confirmed it
///   unproved   fewer than kProof samples were confirmed: its first results are audited as a whole, as far as the image
///              affords it (shared_request.h); of the others an unpredictable part is, as of a proved worker's
///   proved     it may audit other workers
/// A worker whose every result is wrong is therefore found at its first one, before a film has it. One that falsifies a
/// pixel of every nth result is found within R results with a probability of 1 - (1 - 1 / kOneIn)^(R / n): for n = 20,
/// 64 % within 1,000 results and 99.9 % within 6,840; for n = 200, 10 % and, within 68,400, 99.9 %.
class Trust {
  public:
    explicit Trust(std::uint64_t seed) : random_(seed) {}

    bool isStranger() const { return confirmed_ == 0; }
    bool isProved() const { return confirmed_ >= kProof; }
    /// Draws the part of a result to audit, in whole cells, or none. Each cell is audited with probability 1 / kOneIn.
    std::optional<Tile> partToAudit(const Tile& tile);
    /// Counts samples of that cost in which an audit found no difference.
    void confirmed(double cost) { confirmed_ += cost; }

    static constexpr double kProof = 1 << 17;  ///< cost of the samples that prove a worker: 0.8 % of 512 x 512 x 64
    static constexpr int kOneIn = 50;          ///< one of so many cells is audited

  private:
    double confirmed_ = 0;
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
    bool isDeep = false;    ///< takes leases of several blocks
    bool isProved = false;  ///< enough of its samples were confirmed for it to audit others
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
