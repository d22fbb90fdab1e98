#pragma once
/// Ways to find the first collision of camera rays, with a common interface, so that they can be compared.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/trackers/plain_tracking.h"
#include "render/prepare/flatten.h"

namespace pdr::bench {

/// Rays through the box of the volume, each with its own random numbers. All trackers get the same list.
struct RayList {
    std::vector<Ray> rays;
    std::vector<RandomStream> streams;
};

/// Returns `edge` x `edge` rays through the film of `scene`, jittered in their pixels.
RayList primaryRays(const FlatScene& scene, int edge);

class Tracker {
  public:
    virtual ~Tracker() = default;
    virtual std::string name() const = 0;
    /// Returns the number of rays that collide. Counts no work, so this is the function to time.
    virtual int hits(const RayList& list) = 0;
    /// Returns the work that the rays take; null if it cannot be counted.
    virtual std::optional<Work> work(const RayList& list) = 0;
};

/// Returns all trackers, in the order of the table. `prepared` must outlive them.
std::vector<std::unique_ptr<Tracker>> allTrackers(const PreparedScene& prepared);

/// Places of the trackers in that order.
enum TrackerPlace { kMarch, kFineMarch, kGlobal, kSingleLevel, kTwoLevel, kLanesTwoLevel };

}  // namespace pdr::bench
