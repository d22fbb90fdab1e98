#pragma once
/// The render thread of one user of a device: takes scenes and leases, and returns results. Thread-safe.

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <variant>

#include "render/device/device.h"
#include "render/scene/scene.h"
#include "render/tiles/fair_turns.h"
#include "render/tiles/lease.h"

namespace pdr {

/// The answer to a scene: it is loaded, or it could not be.
struct SceneTaken {
    std::uint64_t scene = 0;
    std::optional<Error> error;  ///< why it could not be loaded; none: it is loaded
};
/// The answer to a lease that failed, with the reason.
struct LeaseLost {
    std::uint64_t lease = 0;
    Error error;
};
using LeaseAnswer = std::variant<SceneTaken, LeaseResult, LeaseLost>;

class LeaseRenderer {
  public:
    /// Receives answers; called on the render thread.
    using Answered = std::function<void(LeaseAnswer)>;

    /// Scenes are loaded and leases rendered in `turns`, which must outlive it. Its destructor unloads the scene and
    /// does not wait for the turns of others.
    LeaseRenderer(std::unique_ptr<Device> device, FairTurns& turns, Answered answered);

    /// Loads a scene, which must have passed its check(), and drops leases of earlier scenes.
    void setScene(std::uint64_t number, std::shared_ptr<const Scene> scene);
    /// Queues a lease. A lease of another scene gets no answer.
    void add(Lease lease);
    /// Drops all leases: they get no answer.
    void drop();
    /// Returns the time that scenes and leases have taken so far, as `turns` counts it [s].
    double seconds() const { return turns_.had(share_); }

  private:
    void run(const std::stop_token& ended);
    /// Loads the newest scene, or renders the oldest lease, if there still is one.
    void work();
    void takeScene(std::uint64_t number, const Scene& scene);
    void take(Lease lease, const std::stop_token& stop);
    /// Drops all leases; needs the lock.
    void dropLeases();

    std::unique_ptr<Device> device_;
    FairTurns& turns_;
    FairTurns::Share share_;
    Answered answered_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Lease> leases_;
    std::shared_ptr<const Scene> next_;  ///< scene to load
    std::uint64_t number_ = 0;           ///< number of the newest scene
    bool isNew_ = false;                 ///< next_ is not loaded yet
    std::stop_source current_;           ///< ends the wait for a turn, and stops the lease that is being rendered
    std::jthread thread_;                ///< last member: it uses all others
};

}  // namespace pdr
