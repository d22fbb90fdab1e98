#include "render/volume/clamp.h"

#include <algorithm>

namespace pdr {

Volume clamped(Volume volume, const std::optional<std::pair<int, int>>& interval) {
    if (!interval)
        return volume;
    const auto lowest = std::int16_t(interval->first), highest = std::int16_t(interval->second);
    std::vector<std::int16_t> voxels(volume.voxels().begin(), volume.voxels().end());
    for (std::int16_t& hu : voxels)
        hu = std::clamp(hu, lowest, highest);
    std::vector<bool> padding(volume.paddingCount() > 0 ? voxels.size() : 0);
    for (std::size_t i = 0; i < padding.size(); ++i)
        padding[i] = volume.isPadding(i);
    return Volume(volume.geometry(), std::move(voxels), std::move(padding), volume.remarks());
}

}  // namespace pdr
