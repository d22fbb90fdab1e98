#pragma once
/// One request of samples for a film, rendered by several workers. Results are merged in the sequence in which a single
/// device would have rendered the samples, so that the film is the same to the last bit. Not thread-safe: see
/// pool_state.h.

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "render/film/film.h"
#include "render/tiles/audits.h"
#include "render/tiles/tile_scheduler.h"
#include "render/tiles/worker.h"

namespace pdr {

/// Receives each result that a request merges, in the order of its samples.
using Merged = std::function<void(const LeaseResult& result)>;

class SharedRequest {
  public:
    /// `film` must outlive it. `merged` may be empty. `unspent`: what the request before has left for proofs.
    SharedRequest(Film& film, std::uint64_t scene, const std::vector<TileGoal>& goals, Split split,
                  std::uint64_t firstNumber, const CellCosts& costs, Merged merged = {}, double unspent = 0)
        : film_(film),
          scene_(scene),
          scheduler_(goals, split, firstNumber, costs),
          merged_(std::move(merged)),
          proofCost_(unspent + kMostProof * scheduler_.openCost()) {}

    TileScheduler& scheduler() { return scheduler_; }
    const TileScheduler& scheduler() const { return scheduler_; }
    std::uint64_t scene() const { return scene_; }
    const TileProgress& progress() const { return film_.progress(); }
    /// Whether all samples are merged and no audit is left.
    bool isDone() const { return scheduler_.isDone() && audits_.areDone(); }

    /// Returns the lease of a portion, with the sums that it continues.
    Lease leaseOf(const Portion& portion) const;
    /// Merges the result of a portion, or stores it until the blocks before it are merged. Error: the film refuses the
    /// sums.
    Result<void> take(LeaseResult result);

    Audits& audits() { return audits_; }
    /// Returns the next portion of a worker that is not proved, which is audited as a whole before it is merged; none:
    /// nothing is left, kMostProofs of its results wait for their audit, or the request affords no more: all proofs
    /// together cost at most kMostProof of it, and what was left before.
    std::optional<Portion> takeProof(WorkerId worker, const Ability& ability, double now);
    /// Whether the request affords another proof.
    bool affordsProof() const { return scheduler_.leastCost() <= proofCost_; }
    /// Returns what is left for proofs, for the next request: no more than one of them costs. Requests that are too
    /// small for a proof would never prove anybody.
    double unspent() const { return std::min(proofCost_, kProofCost); }
    /// Whether takeProof() has given out the portion of that number.
    bool isProof(std::uint64_t number) const { return proofs_.contains(number); }
    /// Stores the result until it has been audited.
    void withhold(const Worker& worker, const Portion& portion, LeaseResult result);
    /// Queues an audit of a part of a result that is about to be merged. With kMostAudits of that worker in the queue
    /// it does nothing: nobody could keep up.
    void auditPart(const Worker& worker, const LeaseResult& result, const Tile& part);
    /// Takes back the lease of that number that `worker` will not deliver.
    void giveBack(WorkerId worker, std::uint64_t number);
    /// Takes back all leases of `worker`.
    void giveBackAll(WorkerId worker);
    /// Marks a worker as suspect or not: its leases go to others as well.
    void setSuspect(WorkerId worker, bool suspect);
    /// Takes overdue leases back; returns the workers that had them.
    std::vector<WorkerId> expire(double now);

    /// Records that a result of that worker was merged without an audit of the whole result.
    void addContributor(const std::string& key) { contributors_.insert(key); }
    /// Keys of these workers.
    const std::set<std::string>& contributors() const { return contributors_; }
    /// Records the time of a finished lease, from which the costs of cells are learned.
    void addTime(const TimedLease& lease) { times_.push_back(lease); }
    const std::vector<TimedLease>& times() const { return times_; }

    static constexpr std::size_t kMostAudits = 64, kMostProofs = 8;
    static constexpr double kMostProof = 0.05;
    static constexpr double kProofCost = 8192;  ///< cost of a proof, where the cells are not too dear

  private:
    Audit auditOf(const Worker& worker, LeaseResult claimed);
    Result<void> merge(LeaseResult result);
    bool isNext(const LeaseResult& result) const;

    Film& film_;
    std::uint64_t scene_;
    TileScheduler scheduler_;
    Merged merged_;
    std::vector<LeaseResult> early_;  ///< results whose preceding blocks are not merged yet
    Audits audits_;
    double proofCost_;                ///< what proofs may still cost
    std::set<std::uint64_t> proofs_;  ///< numbers of portions that are proofs
    std::set<std::string> contributors_;
    std::vector<TimedLease> times_;
};

}  // namespace pdr
