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

namespace pdr {

/// A result that is to be done again by the own device.
struct Audit {
    WorkerId worker = kOwnDevice;
    LeaseResult claimed;
    Lease lease;
};

class SharedOrder {
  public:
    /// `film` must outlive it.
    SharedOrder(Film& film, std::uint64_t scene, const std::vector<TileGoal>& goals, Split split,
                std::uint64_t firstNumber)
        : film_(film), scene_(scene), scheduler_(goals, split, firstNumber) {}

    TileScheduler& scheduler() { return scheduler_; }
    const TileScheduler& scheduler() const { return scheduler_; }
    std::uint64_t scene() const { return scene_; }
    bool isDone() const { return scheduler_.isDone(); }

    /// The portion with the sums that it goes on from.
    Lease leaseOf(const Portion& portion) const;
    /// Takes the result of a portion that a worker holds. Error: its sums are none.
    Result<void> take(const LeaseResult& result);

    /// Keeps the result until it has been audited.
    void keepForAudit(WorkerId worker, const Portion& portion, LeaseResult result);
    std::optional<Audit> nextAudit();

  private:
    Result<void> merge(const LeaseResult& result);
    bool isNext(const LeaseResult& result) const;

    Film& film_;
    std::uint64_t scene_;
    TileScheduler scheduler_;
    std::vector<LeaseResult> early_;  ///< of blocks whose predecessors are still missing
    std::deque<Audit> audits_;
};

}  // namespace pdr
