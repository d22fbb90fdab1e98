#pragma once
/// One order of samples for a film, filled by several workers. Results are merged in the order in which one device
/// alone would have taken the samples, so that the film is the same to the last bit. No locks: see worker_pool.h.

#include <deque>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "render/film/film.h"
#include "render/tiles/tile_scheduler.h"
#include "render/tiles/worker.h"

namespace pdr {

/// A result, or a part of one, that is to be done again by the own device.
struct Audit {
    WorkerId worker = kOwnDevice;
    std::string key;  ///< the worker's
    LeaseResult claimed;
    Lease lease;
    bool isWithheld = false;  ///< the result is not in the film before that
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
    /// All samples are taken, and no audit is left.
    bool isDone() const { return scheduler_.isDone() && audits_.empty(); }

    /// The portion with the sums that it goes on from.
    Lease leaseOf(const Portion& portion) const;
    /// Takes the result of a portion that a worker holds. Error: its sums are none.
    Result<void> take(LeaseResult result);

    /// Keeps the result until it has been audited.
    void withhold(const WorkerStatus& worker, const Portion& portion, LeaseResult result);
    /// Remembers a part of a result, which is about to be taken, for an audit. Where kMostAudits wait already there is
    /// none: the own device could not keep up with them.
    void auditPart(const WorkerStatus& worker, const Portion& portion, const LeaseResult& result, const Tile& part);
    std::optional<Audit> nextAudit();

    static constexpr std::size_t kMostAudits = 64;

  private:
    Result<void> merge(LeaseResult result);
    bool isNext(const LeaseResult& result) const;

    Film& film_;
    std::uint64_t scene_;
    TileScheduler scheduler_;
    std::vector<LeaseResult> early_;  ///< of blocks whose predecessors are still missing
    std::deque<Audit> audits_;
};

}  // namespace pdr
