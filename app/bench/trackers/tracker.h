#pragma once
/// Ways from the camera to the first collision, behind one face, so that they can be compared.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/trackers/plain_tracking.h"
#include "render/prepare/flatten.h"

namespace pdr::bench {

/// Rays through the volume's box, each with its own random numbers; the same for all trackers.
struct RayList {
    std::vector<Ray> rays;
    std::vector<RandomStream> streams;
};

/// `edge` x `edge` rays through the film of `scene`, jittered in their pixels.
RayList primaryRays(const FlatScene& scene, int edge);

class Tracker {
  public:
    virtual ~Tracker() = default;
    virtual std::string name() const = 0;
    /// How many of the rays collide; nothing is counted on the way, so this is what to take the time of.
    virtual int hits(const RayList& list) = 0;
    /// What the rays take, where it can be counted.
    virtual std::optional<Work> work(const RayList& list) = 0;
};

/// All trackers, in the order of the table. `prepared` must outlive them.
std::vector<std::unique_ptr<Tracker>> allTrackers(const PreparedScene& prepared);

/// Their places in that order.
enum TrackerPlace { kMarch, kFineMarch, kGlobal, kSingleLevel, kTwoLevel, kLanesTwoLevel };

}  // namespace pdr::bench
