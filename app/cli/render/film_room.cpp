#include "app/cli/render/film_room.h"

#include <cstdio>

#include "app/output/film_memory.h"
#include "render/base/errors.h"
#include "render/base/free_memory.h"

namespace pdr::app {

Result<void> roomForFilm(ivec2 size, const DeviceInfo& device) {
    constexpr std::uint64_t kWorthSaying = 1'000'000'000;
    if (auto fits = checkFilmFits(size, device, "Take a smaller --size."); !fits)
        return fits;
    const std::uint64_t needed = filmBytes(size, device), free = freeBytes();
    if (needed >= kWorthSaying && free != kNoMemoryLimit)
        std::fprintf(stderr, "pdrender-cli: an image of %d x %d pixels takes %s of memory, %s are free\n", size.x,
                     size.y, bytesText(needed).c_str(), bytesText(free).c_str());
    return {};
}

}  // namespace pdr::app
