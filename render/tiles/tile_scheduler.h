#pragma once
/// Who renders what of one order of samples: a state machine without threads, clocks or sockets. Portions are cut as
/// workers ask for them, by what their cells cost as far as that is known. What is not delivered in time goes to others
/// as well, and the first result counts.
///   seconds   since some moment, the same for all calls
///   cost      pixels times samples, each worth what its cell costs (cell_costs.h)

#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <vector>

#include "render/base/split.h"
#include "render/tiles/cell_costs.h"
#include "render/tiles/lease.h"

namespace pdr {

/// Whole cells that are equally far, and how far they are to come.
struct TileGoal {
    Tile tile;
    std::uint64_t next = 0, goal = 0;  ///< numbers of samples: the next one, and the first that is not wanted
};

/// What a worker asks for.
struct Ability {
    double cost = 0;       ///< it wants about so much
    double perSecond = 0;  ///< it is believed to do so much; > 0
};

class TileScheduler {
  public:
    /// `firstNumber`: of the first portion; numbers go on from there.
    TileScheduler(const std::vector<TileGoal>& goals, Split split, std::uint64_t firstNumber,
                  CellCosts costs = CellCosts());

    /// Work for that worker; none: there is nothing left for it now.
    std::optional<Portion> take(WorkerId worker, const Ability& ability, double now);
    /// The portion of that number, if `worker` still has it.
    std::optional<Portion> heldBy(WorkerId worker, std::uint64_t number) const;
    /// Its result is here and looked at: nobody else gets it meanwhile.
    void arrived(std::uint64_t number);
    /// It is done; what follows on it becomes free.
    void finish(std::uint64_t number);
    /// `worker` will not deliver it.
    void giveBack(WorkerId worker, std::uint64_t number);
    /// `worker` will not deliver anything.
    void giveBackAll(WorkerId worker);
    /// Others get what these have.
    void setSuspect(WorkerId worker, bool suspect);
    /// Takes what is long overdue from those who have it, and tells who.
    std::vector<WorkerId> expire(double now);

    bool isDone() const { return open_.empty() && held_.empty(); }
    double costOf(const Portion& portion) const { return costs_.ofSample(portion.tile) * portion.samples.count; }
    /// Of what nobody has yet.
    double openCost() const;
    std::uint64_t nextNumber() const { return number_; }

    /// Beyond three times the time that it should take, and this, a portion is given to others as well.
    static constexpr double kHedgeSeconds = 0.05;
    /// To the own device, which has nothing else to do then and costs no way, beyond that time once, and this.
    static constexpr double kOwnHedgeSeconds = 0.005;
    /// Beyond four times that time, and this, it is taken away.
    static constexpr double kExpirySeconds = 3;

  private:
    struct Copy {
        WorkerId worker;
        double since, expectedSeconds;
    };
    struct Held {
        Portion portion;
        std::uint64_t goal;
        std::vector<Copy> copies;
        bool followed = false;  ///< what comes after it is free already
        bool arrived = false;
    };

    std::optional<Portion> cut(WorkerId worker, const Ability& ability, double now);
    std::optional<Portion> hedge(WorkerId worker, const Ability& ability, double now);
    Tile part(const Tile& tile, double cost) const;
    void free(const TileGoal& goal, bool first);
    bool isLate(const Held& held, WorkerId whoAsks, double now) const;
    double costHeldBy(WorkerId worker) const;
    Copy copyFor(WorkerId worker, const Portion& portion, const Ability& ability, double now) const;
    std::vector<Held>::iterator find(std::uint64_t number);
    /// Without `worker`'s copy; where that was the last, it becomes free.
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
