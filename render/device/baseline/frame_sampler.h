#pragma once
/// How a device takes one sample of every pixel: all that the schedule of Exposure Render asks of it.

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
    vec3 radiance;             ///< linear Rec. 709; 0 where it does not count
    std::uint16_t counts = 0;  ///< 1, or 0: it was no radiance
    std::uint16_t seen = 0;    ///< kSeen...
};

class FrameSampler {
  public:
    virtual ~FrameSampler() = default;

    /// The next frames are of that part of the image. Errors are told by the next sample.
    virtual void restart(const Tile& area) = 0;
    /// Writes sample `number` of every pixel to `frame`, device memory, row by row from the top; orders it or does it.
    /// After a stop request the frame is worthless. Errors: the device's.
    virtual Result<void> sample(std::uint64_t number, SampledPixel* frame, std::stop_token stop) = 0;
    /// What went wrong with samples since it was last asked.
    virtual Result<Health> takeHealth() = 0;

    /// The uploaded scene, on the host (null: there is none, and no sample will be taken) ...
    virtual std::shared_ptr<const PreparedScene> scene() const = 0;
    /// ... and as programs read it.
    virtual FlatScene sceneOnDevice() const = 0;
};

}  // namespace pdr
