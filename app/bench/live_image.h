#pragma once
/// Device with an uploaded scene and an empty film: the start of most measurements.

#include <memory>
#include <string>

#include "render/device/device_list.h"

namespace pdr::bench {

struct LiveImage {
    std::unique_ptr<Device> device;
    std::unique_ptr<Accumulator> live;  ///< declared after the device, which must outlive it
};

/// Opens a device by its name, uploads `scene` and makes an empty film. `threads`: CPU threads; 0: one per core.
/// Errors: those of the device.
Result<LiveImage> startFilm(const Scene& scene, const std::string& device, int threads = 0);

}  // namespace pdr::bench
