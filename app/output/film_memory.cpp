#include "app/output/film_memory.h"

#include <string>

#include "render/base/errors.h"
#include "render/base/free_memory.h"
#include "render/film/moments.h"

namespace pdr::app {

std::uint64_t filmBytes(ivec2 size, const DeviceInfo& device) {
    constexpr std::uint64_t kImage = 4, kFilm = sizeof(PixelSums) + sizeof(Moments);
    return std::uint64_t(size.x) * std::uint64_t(size.y) * ((device.hostMemory ? 2 : 1) * kFilm + kImage);
}

Result<void> checkFilmFits(ivec2 size, const DeviceInfo& device, const Text& hint) {
    const std::uint64_t needed = filmBytes(size, device), free = freeBytes();
    if (needed <= free)
        return {};
    return Error{phrase("an image of %1 x %2 pixels needs %3 of memory, %4 are free", size.x, size.y, bytesText(needed),
                        bytesText(free)),
                 "", hint, ErrorKind::memory};
}

}  // namespace pdr::app
