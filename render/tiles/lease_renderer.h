#pragma once
/// The render thread of a node: scenes and leases in, results out.

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
#include "render/tiles/lease.h"

namespace pdr {

/// The scene of that number can be rendered from now on, or cannot, and why.
struct SceneTaken {
    std::uint64_t scene = 0;
    std::optional<Error> error;
};
/// A lease that will have no result, and why.
struct LeaseLost {
    std::uint64_t lease = 0;
    Error error;
};
using LeaseAnswer = std::variant<SceneTaken, LeaseResult, LeaseLost>;

class LeaseRenderer {
  public:
    /// Called on the render thread.
    using Answered = std::function<void(LeaseAnswer)>;

    LeaseRenderer(std::unique_ptr<Device> device, Answered answered);

    /// The leases that come next are of this scene, which must have passed its check(). Those of others are dropped.
    void setScene(std::uint64_t number, std::shared_ptr<const Scene> scene);
    void add(Lease lease);
    /// Leases that have no answer yet will have none.
    void drop();
    /// All leases are dropped, and the scene is forgotten, on the device as well; waits for that.
    void forget();

  private:
    void run(const std::stop_token& ended);
    void takeScene(std::uint64_t number, const std::shared_ptr<const Scene>& scene);
    void take(Lease lease, const std::stop_token& stop);
    /// To be called with the lock.
    void dropLeases();

    std::unique_ptr<Device> device_;
    Answered answered_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Lease> leases_;
    std::shared_ptr<const Scene> next_;  ///< to be uploaded
    std::uint64_t number_ = 0;           ///< of the newest scene
    bool isNew_ = false;                 ///< it is not uploaded yet, or not forgotten
    bool isBusy_ = false;
    std::stop_source current_;  ///< stops the lease that is on its way
    std::jthread thread_;       ///< last: it uses all of these
};

}  // namespace pdr
