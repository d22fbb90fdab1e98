#pragma once
/// A device that takes samples: the CPU or a GPU.

#include <memory>
#include <stop_token>
#include <string>

#include "render/base/result.h"
#include "render/base/tile.h"
#include "render/device/accumulator.h"
#include "render/film/display/enlarged_film.h"
#include "render/scene/schedule.h"

namespace pdr {

struct Scene;

struct DeviceInfo {
    std::string name;           ///< "cpu"
    std::string details;        ///< description for the user: "2 threads"
    bool hostMemory = false;    ///< whether its results lie in this program's memory, and are lost only with it
    std::size_t freeBytes = 0;  ///< free bytes of the device's own memory, now
};

class Device {
  public:
    virtual ~Device() = default;

    virtual DeviceInfo info() const = 0;
    /// Uploads the scene that films are made of from now on; it must have passed Scene::check(). What it shares with
    /// the previous scene is not made or sent again. Errors: it does not fit (figures: needed, free).
    virtual Result<void> upload(const Scene& scene) = 0;
    /// Forgets the scene and releases its memory, including the volume. Errors: the device's.
    virtual Result<void> unload() = 0;
    /// Returns an empty film for images of the uploaded scenes, or for the part `area` of them; it must not outlive the
    /// device. Errors: not enough memory.
    virtual Result<std::unique_ptr<Accumulator>> film(const Tile& area, std::uint64_t revision,
                                                      const Schedule& schedule) = 0;
    /// Adds `samples` of every pixel of `tile` to `sums`, in order; both are parts of the uploaded scene's image. If
    /// `sums` begins with the block's samples before those, the result is equal to the sums that film() would have.
    /// After a stop request the sums are invalid. Errors: the device's, or that it takes samples for its own films
    /// only.
    virtual Result<void> trace(const Tile& tile, SampleRange samples, TileSums sums, const std::stop_token& stop);
    /// Renders a guide for images that must come soon: the uploaded scene without noise or shadows. Null if the device
    /// has no guide, for this scene or any, or if a stop request came before its end.
    virtual std::shared_ptr<const denoise::Guide> guide(const denoise::GuideRays& /*rays*/,
                                                        const std::stop_token& /*stop*/) {
        return nullptr;
    }
    /// Returns whether none of these contributors to a film has lied.
    virtual bool trusts(const Contributors& /*contributors*/) const { return true; }
    /// Returns an empty film for whole images of that size.
    Result<std::unique_ptr<Accumulator>> film(ivec2 size, std::uint64_t revision, const Schedule& schedule) {
        return film(wholeImage(size), revision, schedule);
    }
};

/// Uploads `scene`, which must have passed Scene::check(), to `device`, and returns an empty film of it.
Result<std::unique_ptr<Accumulator>> startFilm(Device& device, const Scene& scene);

/// Makes the device of the CPU with `threads` threads; 0 = one per core.
std::unique_ptr<Device> makeCpuDevice(int threads = 0);

}  // namespace pdr
