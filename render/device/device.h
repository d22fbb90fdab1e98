#pragma once
/// Something that can take samples: the CPU, a GPU, later another machine.

#include <memory>
#include <stop_token>
#include <string>

#include "render/base/result.h"
#include "render/base/tile.h"
#include "render/device/accumulator.h"
#include "render/film/display/guided_picture.h"
#include "render/scene/schedule.h"

namespace pdr {

struct Scene;

struct DeviceInfo {
    std::string name;           ///< "cpu"
    std::string details;        ///< for the user: "2 threads"
    bool hostMemory = false;    ///< what it computes lies in the memory of this program, and is lost only with it
    std::size_t freeBytes = 0;  ///< of a memory of its own, now
};

class Device {
  public:
    virtual ~Device() = default;

    virtual DeviceInfo info() const = 0;
    /// Takes the scene that films are made of from now on, which must have passed Scene::check(). What it shares with
    /// the one before is not made or sent again. Errors: it does not fit (figures: needed, free).
    virtual Result<void> upload(const Scene& scene) = 0;
    /// Forgets the scene: what it needed is given back, its volume among it. Errors: the device's.
    virtual Result<void> unload() = 0;
    /// An empty film for pictures of the uploaded scenes, or for the part `area` of them; it must not outlive the
    /// device. Errors: no room for it.
    virtual Result<std::unique_ptr<Accumulator>> film(const Tile& area, std::uint64_t revision,
                                                      const Schedule& schedule) = 0;
    /// Adds `samples` of every pixel of `tile` to `sums`, in order; both are parts of the uploaded scene's image. Who
    /// begins with the sums of the block's samples before those gets the sums that film() would have. After a stop
    /// request the sums are worthless. Errors: the device's, or that it takes samples for films of its own only.
    virtual Result<void> trace(const Tile& tile, SampleRange samples, TileSums sums, const std::stop_token& stop);
    /// For pictures that must come soon: the uploaded scene without noise or shadows, `finer` pixels along each of a
    /// film's. Null: it has none, of this scene or of any, or a stop request came before its end.
    virtual std::shared_ptr<const denoise::Guide> guide(int /*finer*/, const std::stop_token& /*stop*/) {
        return nullptr;
    }
    /// For whole pictures of that size.
    Result<std::unique_ptr<Accumulator>> film(ivec2 size, std::uint64_t revision, const Schedule& schedule) {
        return film(wholeImage(size), revision, schedule);
    }
};

/// `scene`, which must have passed Scene::check(), is uploaded to `device`, and an empty film is made of it.
Result<std::unique_ptr<Accumulator>> startFilm(Device& device, const Scene& scene);

/// The CPU with `threads` threads; 0 = one per core.
std::unique_ptr<Device> makeCpuDevice(int threads = 0);

}  // namespace pdr
