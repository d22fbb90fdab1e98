#pragma once
/// The state that the faces of a worker pool share, and the locks that guard it.
///
/// Locks:
///   mutex         guards all public members; the classes of their types have no locks.
///   noticeMutex_  guards the notice, and is held while the notice runs.
/// A thread holds one of them at a time, so they need no order: a face changes the state, wakes the own device through
/// `changed`, releases `mutex`, and calls notify() last. The notice must not call the pool; it posts to another thread.
/// No lock is held while a device renders or a message is sent. The film of a request is written under `mutex` from
/// begin() to end(); at other times it belongs to the thread that makes requests.

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "render/tiles/kept_cells.h"
#include "render/tiles/lease_times.h"
#include "render/tiles/node_checks.h"
#include "render/tiles/published_scenes.h"
#include "render/tiles/shared_request.h"
#include "render/tiles/worker_registry.h"
#include "render/timing/split_choice.h"

namespace pdr {

/// This program's own device, seen as one more worker.
struct OwnDevice {
    bool helps = true;  ///< false: it only audits, unless no worker takes work
    WorkerSpeed speed;
    double taken = 0;  ///< time at which it took its lease [s]
    double work = 0;   ///< work that it has done for requests
};

class PoolState {
  public:
    PoolState(std::uint64_t seed, std::function<double()> monotonicSeconds)
        : clock(std::move(monotonicSeconds)), registry(seed) {}

    const std::function<double()> clock;  ///< monotonic seconds
    std::mutex mutex;
    std::condition_variable_any changed;  ///< wakes the thread that makes requests
    WorkerRegistry registry;
    PublishedScenes scenes;
    std::unique_ptr<SharedRequest> request;  ///< null: there is none
    std::uint64_t nextLease = 1;             ///< number of the next request's first lease
    double unspentProofs = 0;                ///< what earlier requests have left for proofs
    OwnDevice own;
    CellCosts costs;
    KeptCells kept;  ///< who has rendered which cells of the scene that workers have
    LeaseTimes times;
    std::optional<Split> pinnedSplit;  ///< none: the cost model decides
    SplitChoice split;                 ///< split of the last request
    bool checksAll = false;            ///< every result of a worker is withheld until it has been rendered again
    NodeChecks checks;                 ///< what was checked for the scene that workers have
    std::uint64_t checkedScene = 0;    ///< number of that scene
    NodeChecks earlierChecks;          ///< what was checked before `checks`

    // The caller of these holds `mutex`.

    /// Whether workers may sample the request: there is one, and no other scene has priority over its scene.
    bool isRequestCurrent() const { return request && request->scene() == scenes.current().number; }
    /// Whether a worker takes leases of the request. A stranger takes none that the request cannot afford to prove.
    bool isAnyTaking() const;
    /// Whether a worker that takes leases of the request may check that one.
    bool mayAnyCheck(const Audit& audit) const;
    /// Returns what to ask the scheduler of the request for.
    Ability abilityOf(const WorkerSpeed& speed, bool isDeep) const;
    /// Returns the next lease of a worker that takes leases of the request: an audit before anything else.
    std::optional<Lease> leaseFor(const Worker& worker, double now);
    /// Records the time of a portion of the request; `busySeconds`: the part of it that the worker reports as spent on
    /// samples.
    void addTime(WorkerId worker, WorkerSpeed& speed, const Portion& portion, double seconds, double busySeconds);
    /// Counts a merged result of a worker; null: the worker has left.
    void count(Worker* worker, const Portion& portion);
    /// Ends an audit by `truth`, the samples as the own device or a second worker found them: rewards the worker that
    /// sent the same, quarantines one that did not, and merges `truth` if the result was withheld. Error: the film
    /// refuses the sums.
    Result<void> conclude(const Audit& audit, LeaseResult truth);
    /// Forgets what is known of a film that is no longer rendered.
    void forgetFilm();
    /// Quarantines all workers of that key and takes their portions back.
    void quarantine(const std::string& key, const Text& reason);

    // The caller of these does not hold `mutex`.

    void setNotice(std::function<void()> notice);
    /// Calls the notice, if one is set.
    void notify() const;

  private:
    mutable std::mutex noticeMutex_;
    std::function<void()> notice_;
};

}  // namespace pdr
