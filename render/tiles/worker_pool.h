#pragma once
/// The workers (threads, or render nodes behind a network) that sample images beside this program's own device, with
/// their trust, speed and leases. Thread-safe. Two sides call it, each from its own threads: the transport, which
/// connects the workers, and the device that renders an image. No call blocks on a worker: samples that a worker does
/// not deliver in time are rendered by another one or by the own device.

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

/// Monotonic seconds since an arbitrary epoch.
using PoolClock = std::function<double()>;
/// The default clock.
double poolSeconds();

/// Purpose of an image. There may be one image of each purpose at a time: workers then sample the final render, and the
/// viewport continues with its own device alone.
enum class Purpose {
    viewport,    ///< the interactive image
    finalRender  ///< an image for a file
};

/// The scene that leases refer to.
struct PublishedScene {
    std::uint64_t number = 0;            ///< unique; 0: nothing was published yet
    std::shared_ptr<const Scene> scene;  ///< null: withdrawn, workers erase what they have
    Purpose purpose = Purpose::viewport;
};

class WorkerPool {
  public:
    /// `seed`: for choosing audits, which workers must not be able to predict.
    explicit WorkerPool(std::uint64_t seed, PoolClock clock = poolSeconds);

    // ---- for the transport

    /// Sets a function that is called on any thread when there may be a scene to send or work to take. It must return
    /// at once and not call the pool. Once this call has returned, the previous function is not called any more.
    void setNotice(std::function<void()> notice);
    /// Adds a worker. `key` identifies it, also when it reconnects; its trust or quarantine is stored under this key.
    WorkerId join(const std::string& key, const std::string& name);
    void leave(WorkerId worker);
    /// Returns the scene that workers are to load.
    PublishedScene scene() const;
    /// Records that the worker has loaded that scene and owes no lease of an earlier one.
    void hasScene(WorkerId worker, std::uint64_t scene);
    void cannotTakeScene(WorkerId worker, const Text& reason);
    void setSuspect(WorkerId worker, bool suspect);
    void setPaused(WorkerId worker, bool paused);
    void setDraining(WorkerId worker);
    /// Returns the worker's next lease; none: nothing now, ask again after the next notice.
    std::optional<Lease> take(WorkerId worker);
    void deliver(WorkerId worker, LeaseResult result);
    void abandon(WorkerId worker, std::uint64_t lease);
    /// Quarantines a worker that has sent an impossible result: it gets no more leases.
    void quarantine(WorkerId worker, const Text& reason);
    /// Takes overdue leases back; call it several times a second.
    void tick();

    // ---- for the device that renders an image

    /// Sets the scene of the next requests for that purpose (null: there will be none). Returns its number.
    std::uint64_t publish(Purpose purpose, std::shared_ptr<const Scene> scene);
    /// Withdraws that scene, unless another one has replaced it already.
    void withdraw(std::uint64_t scene);
    /// Pins how requests are split; none: the cost model decides (timing/split_choice.h).
    void setSplit(std::optional<Split> split);
    /// Returns the split of the last request, with the reason.
    SplitChoice split() const;
    /// Whether there is a worker that is not quarantined.
    bool hasWorkers() const;
    /// Sets whether the own device renders, too. False: it only audits, unless no worker takes work.
    void setOwnHelps(bool helps);

    /// Begins a request for `film` with that scene; waits until an earlier request has ended. False: the workers are
    /// needed for another scene, or `stop` was requested; the own device then renders alone.
    bool begin(Film& film, std::uint64_t scene, const std::vector<TileGoal>& goals, const std::stop_token& stop);
    /// Work for the own device.
    struct OwnWork {
        std::optional<Audit> audit;  ///< none: the lease is no audit
        Lease lease;
    };
    /// Waits for the next work of the own device: an audit or a lease. None: the request is done, or `stop` was
    /// requested.
    std::optional<OwnWork> nextOwn(const std::stop_token& stop);
    /// Merges a result of the own device, unless a worker was faster. Error: the film refuses the sums.
    Result<void> deliverOwn(LeaseResult result);
    /// Compares an audited result with `truth`, the own device's result for the same samples, and merges `truth` if the
    /// audited result was withheld. Error: the film refuses the sums.
    Result<void> audited(const Audit& audit, LeaseResult truth);
    /// Ends the request, done or not. Returns the keys of the workers whose results were accepted without a full audit.
    std::set<std::string> end();
    /// Whether one of these workers has been quarantined for a wrong result since.
    bool areLiarsAmong(const std::set<std::string>& keys) const;

    // ---- for display

    std::vector<WorkerStatus> workers() const;
    /// Returns the status of a worker; none: it has left.
    std::optional<WorkerStatus> worker(WorkerId worker) const;
    /// Work that the own device has done for requests.
    double ownWork() const;

    /// Limits on the target duration of a portion [s]: minimum, maximum, maximum while the cost of cells is unknown,
    /// maximum on probation.
    static constexpr double kShortestSeconds = 0.004, kLongestSeconds = 0.3, kUnknownSeconds = 0.1,
                            kProbationSeconds = 0.01;
    /// Leases that a worker may owe at a time: the second one hides the round trip.
    static constexpr int kInFlight = 2;

  private:
    struct Past {  ///< state of a worker that has left
        Trust trust;
        Text quarantine;  ///< reason for its quarantine; empty: none
    };

    Worker* find(WorkerId worker);
    const PublishedScene& wanted() const { return finalRender_.scene ? finalRender_ : viewport_; }
    /// Whether workers may sample the request: no published scene has priority over it.
    bool isOrderWanted() const { return order_ && order_->scene() == wanted().number; }
    void setPublished(PublishedScene& published, std::shared_ptr<const Scene> scene);
    Ability abilityOf(const WorkerSpeed& speed, bool isOnProbation) const;
    /// Records the time of a portion; `busySeconds`: the part of it that the worker reports as spent on samples.
    void timed(WorkerId worker, WorkerSpeed& speed, const Portion& portion, double seconds, double busySeconds);
    bool anyTakesWork() const;
    SplitChoice choose(const std::vector<TileGoal>& goals) const;
    /// Merges the result of a trusted worker.
    void believe(Worker& worker, const Portion& portion, LeaseResult result);
    /// Quarantines a worker and takes its portions back.
    void caught(Worker& worker, const Text& reason);
    /// Calls the notice; must be called without the lock.
    void tell() const;

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    mutable std::mutex noticeMutex_;
    std::function<void()> notice_;  ///< guarded by noticeMutex_
    PoolClock clock_;
    std::uint64_t seed_;
    std::map<WorkerId, Worker> workers_;
    std::map<std::string, Past> past_;  ///< workers that have left, by key
    std::set<std::string> liars_;       ///< keys of untrusted nodes
    WorkerId nextWorker_ = 1;
    PublishedScene viewport_{}, finalRender_{0, nullptr, Purpose::finalRender};
    std::uint64_t published_ = 0;  ///< number of the last published scene
    std::unique_ptr<SharedOrder> order_;
    std::set<std::string> believed_;  ///< keys of workers whose results the request accepted without a full audit
    std::uint64_t nextLease_ = 1;
    std::optional<Split> pinned_;
    SplitChoice split_;
    CellCosts costs_;
    std::vector<TimedLease> timed_;  ///< finished leases of the request
    LeaseTimes times_;
    bool ownHelps_ = true;
    WorkerSpeed ownSpeed_;
    double ownTaken_ = 0;  ///< time at which the own device took its lease [s]
    double ownWork_ = 0;
};

}  // namespace pdr
