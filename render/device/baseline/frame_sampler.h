#pragma once
/// Interface that takes one sample of every pixel: all that Exposure Render's schedule needs from a device.

#include <cstdint>
#include <memory>
#include <stop_token>

#include "render/base/health.h"
#include "render/base/result.h"
#include "render/base/tile.h"
#include "render/prepare/prepared_scene.h"

namespace pdr {

/// One sample of one pixel.
struct alignas(16) SampledPixel {
    vec3 radiance;             ///< linear Rec. 709; 0 if it does not count
    std::uint16_t counts = 0;  ///< 1, or 0 if it was not a valid radiance
    std::uint16_t seen = 0;    ///< flags: kSeen...
};

class FrameSampler {
  public:
    virtual ~FrameSampler() = default;

    /// Sets the part of the image that the next frames show. Errors are reported by the next sample().
    virtual void restart(const Tile& area) = 0;
    /// Writes sample `number` of every pixel to `frame`, device memory, row by row from the top, at once or
    /// asynchronously. After a stop request the frame is invalid. Errors: the device's.
    virtual Result<void> sample(std::uint64_t number, SampledPixel* frame, std::stop_token stop) = 0;
    /// Returns the faults of samples since the last call.
    virtual Result<Health> takeHealth() = 0;

    /// Returns the uploaded scene, on the host; null if there is none, and then no sample will be taken.
    virtual std::shared_ptr<const PreparedScene> scene() const = 0;
    /// Returns the uploaded scene as programs on the device read it.
    virtual FlatScene sceneOnDevice() const = 0;
};

}  // namespace pdr
