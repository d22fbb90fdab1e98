#pragma once
/// The face of a worker pool that the device which renders an image calls: it publishes scenes, requests samples, and
/// renders its own part of each request. Thread-safe. There is one request at a time, of one thread: begin() waits for
/// its turn, and the calls up to end() belong to the thread that began.

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "render/tiles/node_checks.h"
#include "render/tiles/published_scenes.h"
#include "render/tiles/shared_request.h"

namespace pdr {

class PoolState;

class SharedWork {
  public:
    SharedWork(const SharedWork&) = delete;
    SharedWork& operator=(const SharedWork&) = delete;

    /// Sets the scene of the next requests for that purpose (null: there will be none). Returns its number.
    std::uint64_t publish(Purpose purpose, std::shared_ptr<const Scene> scene);
    /// Withdraws that scene, unless another one has replaced it already.
    void withdraw(std::uint64_t scene);

    /// Number of connected workers.
    std::size_t countWorkers() const;
    /// Whether there is a worker that is not quarantined.
    bool hasWorkers() const;
    /// Whether there is a worker that takes leases of that scene now.
    bool isTaken(std::uint64_t scene) const;

    /// Begins a request for `film` with that scene; waits until an earlier request has ended. False: the workers are
    /// needed for another scene, or `stop` was requested; the own device then renders alone. `merged` is called under
    /// the lock of the pool.
    bool begin(Film& film, std::uint64_t scene, const std::vector<TileGoal>& goals, const std::stop_token& stop,
               const Merged& merged = {});
    /// Work for the own device.
    struct OwnWork {
        std::optional<Audit> audit;  ///< none: the lease is no audit
        std::optional<Lease> lease;  ///< none: there is nothing to do now
    };
    /// Waits for the next work of the own device: an audit or a lease; not longer than a fraction of a second. None:
    /// the request is done, or `stop` was requested.
    std::optional<OwnWork> nextOwn(const std::stop_token& stop);
    /// Returns the samples that the film of the request has.
    SampleCounts merged() const;
    /// Merges a result of the own device, unless a worker was faster. Error: the film refuses the sums.
    Result<void> deliverOwn(LeaseResult result);
    /// Ends an audit by `truth`, the own device's result for the same samples, and merges `truth` if the audited result
    /// was withheld. Error: the film refuses the sums.
    Result<void> audited(const Audit& audit, LeaseResult truth);
    /// Ends the request, done or not. Returns the keys of the workers whose results were merged without a full audit.
    std::set<std::string> end();
    /// Returns what was checked of the results of workers for the scene that they have.
    NodeChecks checks() const;
    /// Returns that for all scenes that there have been.
    NodeChecks allChecks() const;
    /// Records that all samples of that scene were discarded.
    void discarded();
    /// Whether one of these workers has been quarantined for a wrong result.
    bool isAnyUntrusted(const std::set<std::string>& keys) const;

  protected:
    explicit SharedWork(std::shared_ptr<PoolState> state);
    ~SharedWork();

  private:
    /// Applies a change of the scenes to the request: takes back what workers hold of it if they now have another scene
    /// to render.
    void sceneChanged();
    /// Returns the next work of the own device, if there is any now.
    std::optional<OwnWork> ownWork(SharedRequest& request);

    std::shared_ptr<PoolState> state_;
};

}  // namespace pdr
