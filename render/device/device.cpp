#include "render/device/device.h"

#include "render/scene/scene.h"

namespace pdr {

Result<std::unique_ptr<Accumulator>> startFilm(Device& device, const Scene& scene) {
    if (const auto uploaded = device.upload(scene); !uploaded)
        return uploaded.error();
    return device.film(scene.film, scene.revision, scene.schedule);
}

}  // namespace pdr
