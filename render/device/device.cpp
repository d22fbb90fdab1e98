#include "render/device/device.h"

#include "render/scene/scene.h"

namespace pdr {

Result<void> Device::trace(const Tile&, SampleRange, TileSums, const std::stop_token&) {
    return Error{phrase("the device takes samples for films of its own only"), info().name, ""};
}

Result<std::unique_ptr<Accumulator>> startFilm(Device& device, const Scene& scene) {
    if (const auto uploaded = device.upload(scene); !uploaded)
        return uploaded.error();
    return device.film(scene.film, scene.revision, scene.schedule);
}

}  // namespace pdr
