#pragma once
/// Those who take samples for the pictures of this program beside its own device, and what they are at. Two sides call
/// it, each from its own threads: who speaks with the workers, and who wants a picture. Nobody is ever waited for: what
/// a worker does not bring is done by another, or by the own device.

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "render/scene/scene.h"
#include "render/tiles/lease_times.h"
#include "render/tiles/shared_order.h"
#include "render/tiles/worker.h"
#include "render/timing/split_choice.h"

namespace pdr {

/// Seconds since some moment, never going back.
using PoolClock = std::function<double()>;
double poolSeconds();

/// What a picture is for. Two may be wanted at a time, one of each kind: workers take samples of the final render as
/// long as there is one, and the device of the viewport has its own to itself.
enum class Purpose {
    viewport,    ///< the picture that is looked at
    finalRender  ///< one that goes into a file
};

/// The scene that leases are of.
struct PublishedScene {
    std::uint64_t number = 0;            ///< tells it from all others; 0: nothing was published yet
    std::shared_ptr<const Scene> scene;  ///< null: what was published is to be forgotten
    Purpose purpose = Purpose::viewport;
};

class WorkerPool {
  public:
    /// `seed`: of the choice of audits, which workers must not foresee.
    explicit WorkerPool(std::uint64_t seed, PoolClock clock = poolSeconds);

    // ---- for who speaks with the workers

    /// Called when there is a scene to send, or work to take, or neither any more; on any thread. It must return at
    /// once and not call back. Not called any more when this has returned with another one.
    void setNotice(std::function<void()> notice);
    /// `key`: what tells it from all others and is the same when it comes back, with the trust that it has earned.
    WorkerId join(const std::string& key, const std::string& name);
    void leave(WorkerId worker);
    PublishedScene scene() const;
    /// It can take samples of that scene from now on.
    void hasScene(WorkerId worker, std::uint64_t scene);
    void cannotTakeScene(WorkerId worker, const std::string& reason);
    void setSuspect(WorkerId worker, bool suspect);
    void setPaused(WorkerId worker, bool paused);
    void setDraining(WorkerId worker);
    /// Work for it; none: nothing now, ask again when there is notice.
    std::optional<Lease> take(WorkerId worker);
    void deliver(WorkerId worker, LeaseResult result);
    void abandon(WorkerId worker, std::uint64_t lease);
    /// What it has sent cannot be true: it gets nothing any more.
    void quarantine(WorkerId worker, const std::string& reason);
    /// Takes back what is overdue; to be called some times a second.
    void tick();

    // ---- for who wants a picture

    /// The scene of the next orders for that purpose; null: there are none. Returns its number.
    std::uint64_t publish(Purpose purpose, std::shared_ptr<const Scene> scene);
    /// The scene of that number is no longer wanted, if another one has not taken its place already.
    void withdraw(std::uint64_t scene);
    /// How orders are cut; none: as a model of their costs says (timing/split_choice.h).
    void setSplit(std::optional<Split> split);
    /// Of the last order, and why.
    SplitChoice split() const;
    /// Whether anybody but the own device could take samples.
    bool hasWorkers() const;
    /// The own device takes samples only where nobody else can, and audits.
    void setOwnHelps(bool helps);

    /// Begins an order for `film`, of the scene of that number; waits until the last order of another scene has ended.
    /// False: workers are wanted for another scene, or `stop` is requested; the own device does it alone.
    bool begin(Film& film, std::uint64_t scene, const std::vector<TileGoal>& goals, const std::stop_token& stop);
    /// What the own device is to do next: an audit, or a lease. Waits for it, and returns none when the order is done
    /// or `stop` is requested.
    struct OwnWork {
        std::optional<Audit> audit;
        Lease lease;
    };
    std::optional<OwnWork> nextOwn(const std::stop_token& stop);
    /// Error: the sums of the own device are none.
    Result<void> deliverOwn(LeaseResult result);
    /// `truth`: what the own device has found of it.
    Result<void> audited(const Audit& audit, LeaseResult truth);
    /// Ends the order, done or not. Returns the keys of those whose results were believed without an audit.
    std::set<std::string> end();
    /// Whether one of these has been caught lying since.
    bool areLiarsAmong(const std::set<std::string>& keys) const;

    // ---- for who looks on

    std::vector<WorkerStatus> workers() const;
    /// None: it has left.
    std::optional<WorkerStatus> worker(WorkerId worker) const;
    /// Work that the own device has done of orders.
    double ownWork() const;

    /// A portion takes about so long at least and at most [s]; at most this where nobody knows yet what its cells cost;
    /// and this on probation.
    static constexpr double kShortestSeconds = 0.004, kLongestSeconds = 0.3, kUnknownSeconds = 0.1,
                            kProbationSeconds = 0.01;
    /// So many leases wait at a worker, so that it need not wait for the next.
    static constexpr int kInFlight = 2;

  private:
    struct Past {  ///< of a worker, whether it is here or not
        Trust trust;
        std::string quarantine;
    };

    Worker* find(WorkerId worker);
    const PublishedScene& wanted() const { return finalRender_.scene ? finalRender_ : viewport_; }
    /// Workers may take samples of the order: nobody has published a scene that comes before it.
    bool isOrderWanted() const { return order_ && order_->scene() == wanted().number; }
    void setPublished(PublishedScene& published, std::shared_ptr<const Scene> scene);
    Ability abilityOf(const WorkerSpeed& speed, bool isOnProbation) const;
    /// The worker has done that portion in so many seconds, of which it says that it spent `busySeconds` on samples.
    void timed(WorkerId worker, WorkerSpeed& speed, const Portion& portion, double seconds, double busySeconds);
    bool anyTakesWork() const;
    SplitChoice choose(const std::vector<TileGoal>& goals) const;
    /// Takes the result of a trusted worker.
    void believe(Worker& worker, const Portion& portion, LeaseResult result);
    void caught(Worker& worker, const std::string& reason);
    void tell() const;

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    mutable std::mutex noticeMutex_;
    std::function<void()> notice_;  ///< guarded by noticeMutex_
    PoolClock clock_;
    std::uint64_t seed_;
    std::map<WorkerId, Worker> workers_;
    std::map<std::string, Past> past_;  ///< by key, of those who have left
    std::set<std::string> liars_;       ///< keys
    WorkerId nextWorker_ = 1;
    PublishedScene viewport_{}, finalRender_{0, nullptr, Purpose::finalRender};
    std::uint64_t published_ = 0;  ///< number of the last one
    std::unique_ptr<SharedOrder> order_;
    std::set<std::string> believed_;  ///< in the order
    std::uint64_t nextLease_ = 1;
    std::optional<Split> pinned_;
    SplitChoice split_;
    CellCosts costs_;
    std::vector<TimedLease> timed_;  ///< in the order
    LeaseTimes times_;
    bool ownHelps_ = true;
    WorkerSpeed ownSpeed_;
    double ownTaken_ = 0;  ///< when its lease was taken
    double ownWork_ = 0;
};

}  // namespace pdr
