#pragma once
/// One request of samples for a film, rendered by several workers. Results are merged in the sequence in which a single
/// device would have rendered the samples, so that the film is the same to the last bit. Not thread-safe: see
/// pool_state.h.

#include <deque>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "render/film/film.h"
#include "render/tiles/tile_scheduler.h"
#include "render/tiles/worker.h"

namespace pdr {

/// A result, or a part of one, that the own device renders again and compares.
struct Audit {
    WorkerId worker = kOwnDevice;
    std::string key;      ///< key of the worker
    LeaseResult claimed;  ///< what the worker sent; for a part, with the faults of the whole
    Lease lease;
    bool isWithheld = false;  ///< the result is merged only after the audit
};

class SharedRequest {
  public:
    /// `film` must outlive it.
    SharedRequest(Film& film, std::uint64_t scene, const std::vector<TileGoal>& goals, Split split,
                  std::uint64_t firstNumber, const CellCosts& costs)
        : film_(film), scene_(scene), scheduler_(goals, split, firstNumber, costs) {}

    TileScheduler& scheduler() { return scheduler_; }
    const TileScheduler& scheduler() const { return scheduler_; }
    std::uint64_t scene() const { return scene_; }
    const TileProgress& progress() const { return film_.progress(); }
    /// Whether all samples are merged and no audit is left.
    bool isDone() const { return scheduler_.isDone() && audits_.empty(); }

    /// Returns the lease of a portion, with the sums that it continues.
    Lease leaseOf(const Portion& portion) const;
    /// Merges the result of a portion, or stores it until the blocks before it are merged. Error: the film refuses the
    /// sums.
    Result<void> take(LeaseResult result);

    /// Stores the result until it has been audited.
    void withhold(const WorkerStatus& worker, const Portion& portion, LeaseResult result);
    /// Queues an audit of a part of a result that is about to be merged. With kMostAudits in the queue it does nothing:
    /// the own device could not keep up.
    void auditPart(const WorkerStatus& worker, const Portion& portion, const LeaseResult& result, const Tile& part);
    /// Takes the oldest audit out of the queue; none: the queue is empty.
    std::optional<Audit> nextAudit();

    /// Records that a result of that worker was merged without an audit of the whole result.
    void addContributor(const std::string& key) { contributors_.insert(key); }
    /// Keys of these workers.
    const std::set<std::string>& contributors() const { return contributors_; }
    /// Records the time of a finished lease, from which the costs of cells are learned.
    void addTime(const TimedLease& lease) { times_.push_back(lease); }
    const std::vector<TimedLease>& times() const { return times_; }

    static constexpr std::size_t kMostAudits = 64;

  private:
    Result<void> merge(LeaseResult result);
    bool isNext(const LeaseResult& result) const;

    Film& film_;
    std::uint64_t scene_;
    TileScheduler scheduler_;
    std::vector<LeaseResult> early_;  ///< results whose preceding blocks are not merged yet
    std::deque<Audit> audits_;
    std::set<std::string> contributors_;
    std::vector<TimedLease> times_;
};

}  // namespace pdr
