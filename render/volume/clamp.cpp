#include "render/volume/clamp.h"

namespace pdr {

Volume clamped(Volume volume, const std::optional<std::pair<int, int>>& interval) {
    if (!interval)
        return volume;
    return std::move(volume).clamped(std::int16_t(interval->first), std::int16_t(interval->second));
}

}  // namespace pdr
