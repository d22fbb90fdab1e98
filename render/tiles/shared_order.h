#pragma once
/// One order of samples for a film, rendered by several workers. Results are merged in the sequence in which a single
/// device would have taken the samples, so that the film is the same to the last bit. Not thread-safe: see
/// worker_pool.h.

#include <deque>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "render/film/film.h"
#include "render/tiles/tile_scheduler.h"
#include "render/tiles/worker.h"

namespace pdr {

/// A result, or a part of one, that the own device is to render again.
struct Audit {
    WorkerId worker = kOwnDevice;
    std::string key;      ///< the worker's
    LeaseResult claimed;  ///< of a part: with the faults of the whole
    Lease lease;
    bool isWithheld = false;  ///< the result is merged after the audit only
};

class SharedOrder {
  public:
    /// `film` must outlive it.
    SharedOrder(Film& film, std::uint64_t scene, const std::vector<TileGoal>& goals, Split split,
                std::uint64_t firstNumber, const CellCosts& costs)
        : film_(film), scene_(scene), scheduler_(goals, split, firstNumber, costs) {}

    TileScheduler& scheduler() { return scheduler_; }
    const TileScheduler& scheduler() const { return scheduler_; }
    std::uint64_t scene() const { return scene_; }
    /// All samples are merged, and no audit is left.
    bool isDone() const { return scheduler_.isDone() && audits_.empty(); }

    /// The portion with the sums that it continues.
    Lease leaseOf(const Portion& portion) const;
    /// Merges the result of a portion, or keeps it until the blocks before it are merged. Error: the film refuses the
    /// sums.
    Result<void> take(LeaseResult result);

    /// Keeps the result until it has been audited.
    void withhold(const WorkerStatus& worker, const Portion& portion, LeaseResult result);
    /// Queues an audit of a part of a result that is about to be merged. With kMostAudits in the queue it does nothing:
    /// the own device could not keep up.
    void auditPart(const WorkerStatus& worker, const Portion& portion, const LeaseResult& result, const Tile& part);
    std::optional<Audit> nextAudit();

    static constexpr std::size_t kMostAudits = 64;

  private:
    Result<void> merge(LeaseResult result);
    bool isNext(const LeaseResult& result) const;

    Film& film_;
    std::uint64_t scene_;
    TileScheduler scheduler_;
    std::vector<LeaseResult> early_;  ///< results whose preceding blocks are not merged yet
    std::deque<Audit> audits_;
};

}  // namespace pdr
