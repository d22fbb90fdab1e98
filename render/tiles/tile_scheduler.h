#pragma once
/// Divides one request of samples among workers: a pure state machine without threads, clocks or sockets. Portions are
/// cut when workers ask for them, sized by cost. A late portion is given to a second worker as well (hedging), and the
/// first result counts.
///   now    monotonic seconds, from the same clock in all calls
///   cost   pixels times samples, weighted by the cost of the cells (cell_costs.h)

#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "render/base/split.h"
#include "render/tiles/cell_costs.h"
#include "render/tiles/lease.h"

namespace pdr {

/// A tile of whole cells with equally many samples, and the samples that it is to get.
struct TileGoal {
    Tile tile;
    std::uint64_t next = 0, goal = 0;  ///< half-open range of sample indices
    WorkerId keeper = kOwnDevice;      ///< worker that is to have it, if it asks in time; the own device: nobody
};

/// Cost that a worker asks for, and its speed.
struct Ability {
    double cost = 0;       ///< approximate cost of the next portion
    double perSecond = 0;  ///< expected speed; > 0
    double deepest = 0;  ///< limit on the cost of a single cell of a portion of several blocks; 0: one block at a time
    /// Limit on the cost of the portion, which is cut to `cost` then, if need be to a cell and a part of a block; of
    /// samples that are split among workers to a cell of a block. None is given where that costs more than the limit.
    double most = std::numeric_limits<double>::infinity();

    bool isLimited() const { return most < std::numeric_limits<double>::infinity(); }
};

class TileScheduler {
  public:
    /// `firstNumber`: number of the first portion; numbers are consecutive.
    TileScheduler(const std::vector<TileGoal>& goals, Split split, std::uint64_t firstNumber,
                  CellCosts costs = CellCosts());

    /// Returns the next portion of `worker`; none: nothing is left for it now.
    std::optional<Portion> take(WorkerId worker, const Ability& ability, double now);
    /// Returns the portion of that number if `worker` has it and no result of it has arrived.
    std::optional<Portion> heldBy(WorkerId worker, std::uint64_t number) const;
    /// Records that the result of a portion has arrived and is being audited: the portion is not hedged meanwhile.
    void arrived(std::uint64_t number);
    /// Records that the result of a portion is accepted; the samples after it become available.
    void finish(std::uint64_t number);
    /// Takes back a portion that `worker` will not deliver.
    void giveBack(WorkerId worker, std::uint64_t number);
    /// Takes back all portions of `worker`, which will not deliver anything.
    void giveBackAll(WorkerId worker);
    /// Marks a worker as suspect or not. Portions of a suspect worker are hedged at once.
    void setSuspect(WorkerId worker, bool suspect);
    /// Takes overdue portions back; returns the workers that had them.
    std::vector<WorkerId> expire(double now);

    bool isDone() const { return open_.empty() && held_.empty(); }
    double costOf(const Portion& portion) const { return costs_.ofSample(portion.tile) * portion.samples.count; }
    /// Returns the cost of what `worker` has been given and has not delivered.
    double costHeldBy(WorkerId worker) const;
    /// Returns the cost of all samples that no worker has been given yet.
    double openCost() const;
    std::uint64_t nextNumber() const { return number_; }
    /// Returns a number that no portion has or gets, for a lease that is none of the request's.
    std::uint64_t newNumber() { return number_++; }
    /// Returns the cost of the smallest portion that can be cut now; 0: there is none.
    double leastCost() const;

    /// A portion is hedged after three times its expected time plus this time.
    static constexpr double kHedgeSeconds = 0.05;
    /// The own device, which is idle then and has no latency, hedges a portion after its expected time plus this time.
    static constexpr double kOwnHedgeSeconds = 0.005;
    /// A portion is taken back after four times its expected time plus this time.
    static constexpr double kExpirySeconds = 3;

  private:
    /// A portion as one worker has it.
    struct Copy {
        WorkerId worker;
        double since, expectedSeconds;
    };
    /// A portion that workers have.
    struct Held {
        Portion portion;
        std::uint64_t goal;
        std::vector<Copy> copies;
        bool followed = false;  ///< the samples after it are available already
        bool arrived = false;
    };

    std::optional<Portion> cut(WorkerId worker, const Ability& ability, double now);
    std::deque<TileGoal>::iterator openFor(WorkerId worker);
    SampleRange nextSamples(const TileGoal& goal, const Ability& ability) const;
    std::optional<Portion> hedge(WorkerId worker, const Ability& ability, double now);
    Tile part(const Tile& tile, double cost, std::size_t mostPixels) const;
    void free(const TileGoal& goal, bool first);
    bool isLate(const Held& held, WorkerId whoAsks, double now) const;
    Copy copyFor(WorkerId worker, const Portion& portion, const Ability& ability, double now) const;
    std::vector<Held>::iterator find(std::uint64_t number);
    /// Removes `worker`'s copy, unless the result has arrived.
    void drop(Held& held, WorkerId worker);
    void removeFreed();

    Split split_;
    std::uint64_t number_;
    CellCosts costs_;
    std::deque<TileGoal> open_;
    std::vector<Held> held_;
    std::set<WorkerId> suspects_;
};

}  // namespace pdr
