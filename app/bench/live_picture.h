#pragma once
/// A device with a scene on it and an empty film of it: where most measurements begin.

#include <memory>
#include <string>

#include "render/device/device_list.h"

namespace pdr::bench {

struct LivePicture {
    std::unique_ptr<Device> device;
    std::unique_ptr<Accumulator> live;  ///< after the device: it must not outlive it
};

/// `device`: its name; `threads` of the CPU, 0 = one per core. Errors: the device's.
Result<LivePicture> startFilm(const Scene& scene, const std::string& device, int threads = 0);

}  // namespace pdr::bench
