#pragma once
/// Something that can take samples: the CPU, a GPU, later another machine.

#include <memory>
#include <stop_token>
#include <string>

#include "render/base/result.h"
#include "render/base/tile.h"
#include "render/device/live_film.h"
#include "render/device/schedule.h"
#include "render/scene/flatten.h"

namespace pdr {

struct DeviceInfo {
    std::string name;           ///< "cpu"
    std::string details;        ///< for the user: "2 threads"
    bool hostMemory = false;    ///< what it computes lies in the memory of this program, and is lost only with it
    std::size_t freeBytes = 0;  ///< of a memory of its own, now
};

/// Who is to make what rays are led by in scenes for a device: a device that has a memory of its own makes it there.
inline Bounds boundsFor(const DeviceInfo& info) {
    return info.hostMemory ? Bounds::onHost : Bounds::onDevice;
}

class Device {
  public:
    virtual ~Device() = default;

    virtual DeviceInfo info() const = 0;
    /// Takes the scene that the next render() calls use; null: none, and what the one before needed is given back, its
    /// volume among it. Errors: it does not fit (figures: needed, free).
    virtual Result<void> upload(std::shared_ptr<const PreparedScene> scene) = 0;
    /// Adds `samples` of every pixel of `tile` to `sums`, in order. Blocks until done. After a stop request it returns
    /// early and the sums are worthless.
    virtual Result<void> render(const Tile& tile, SampleRange samples, TileSums sums, std::stop_token stop) = 0;
    /// An empty film for pictures of the uploaded scenes of `size` pixels; it must not outlive the device. Errors: no
    /// room for it.
    virtual Result<std::unique_ptr<LiveFilm>> film(ivec2 size, std::uint64_t revision, const Schedule& schedule) = 0;
};

/// The CPU with `threads` threads; 0 = one per core.
std::unique_ptr<Device> makeCpuDevice(int threads = 0);

}  // namespace pdr
