#pragma once
/// The face of a worker pool that the transport calls: it connects workers, tells them the scene to load, gives out
/// leases and takes results. Thread-safe. No call blocks on a worker: samples that a worker does not deliver in time
/// are rendered by another one or by the own device.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "render/tiles/published_scenes.h"
#include "render/tiles/worker.h"

namespace pdr {

class PoolState;
struct Audit;

class LeaseServer {
  public:
    LeaseServer(const LeaseServer&) = delete;
    LeaseServer& operator=(const LeaseServer&) = delete;

    /// Sets a function that is called on any thread when there may be a scene to send or work to take. It must return
    /// at once and not call the pool. Once this call has returned, the previous function is not called any more.
    void setNotice(std::function<void()> notice);

    /// Adds a worker. `key` identifies it, also when it reconnects; its trust or quarantine is stored under this key.
    /// `isDeep`: whether it takes leases of several blocks.
    WorkerId join(const std::string& key, const std::string& name, bool isDeep = true);
    void leave(WorkerId worker);
    /// Returns the status of a worker; none: it has left.
    std::optional<WorkerStatus> status(WorkerId worker) const;
    void setSuspect(WorkerId worker, bool suspect);
    void setPaused(WorkerId worker, bool paused);
    void setDraining(WorkerId worker);
    /// Quarantines a worker that has sent an impossible result: it gets no more leases.
    void quarantine(WorkerId worker, const Text& reason);

    /// Returns the scene that workers are to load.
    PublishedScene scene() const;
    /// Records that the worker has loaded that scene and owes no lease of an earlier one.
    void hasScene(WorkerId worker, std::uint64_t scene);
    void cannotTakeScene(WorkerId worker, const Text& reason);

    /// Returns the worker's next lease; none: nothing now, ask again after the next notice.
    std::optional<Lease> take(WorkerId worker);
    void deliver(WorkerId worker, LeaseResult result);
    void abandon(WorkerId worker, std::uint64_t lease);
    /// Takes overdue leases back; call it several times a second.
    void tick();

    /// Leases that a worker may owe at a time: the second one hides the round trip.
    static constexpr int kInFlight = 2;

  protected:
    explicit LeaseServer(std::shared_ptr<PoolState> state);
    ~LeaseServer();

  private:
    /// Counts a result that comes too late to be used.
    void late(Worker& worker);
    /// Measures the worker by a result that it has sent for `portion`.
    void measure(Worker& worker, const Portion& portion, const LeaseResult& result);
    /// Takes the result of a portion that the worker holds.
    void accept(Worker& worker, const Portion& portion, LeaseResult result);
    /// Merges the result before it is audited.
    void merge(Worker& worker, const Portion& portion, LeaseResult result);
    /// Takes what the worker has found for the samples of another one.
    void check(Worker& worker, Audit audit, LeaseResult result);

    std::shared_ptr<PoolState> state_;
};

}  // namespace pdr
