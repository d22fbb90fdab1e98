#include "dicom/stack/blend.h"

#include <algorithm>
#include <cmath>

namespace pdr::dicom {

namespace {

bool isPadding(const FlaggedVoxels& voxels, std::size_t i) {
    return !voxels.padding.empty() && voxels.padding[i];
}

}  // namespace

FlaggedVoxels blended(const FlaggedVoxels& measured, std::size_t perSlice, std::span<const SliceBlend> blends) {
    FlaggedVoxels made{Voxels(perSlice * blends.size()), {}};
    if (!measured.padding.empty())
        made.padding.resize(made.hu.size());
    for (std::size_t k = 0; k < blends.size(); ++k) {
        const SliceBlend& blend = blends[k];
        const std::size_t low = std::size_t(blend.below) * perSlice, high = std::size_t(blend.above) * perSlice;
        for (std::size_t i = 0; i < perSlice; ++i) {
            const std::size_t to = k * perSlice + i;
            made.hu[to] = std::int16_t(
                std::lround(std::lerp(double(measured.hu[low + i]), double(measured.hu[high + i]), blend.weight)));
            if (blend.weight > 0 && isPadding(measured, low + i) != isPadding(measured, high + i))
                made.hu[to] = Volume::kAirHu;
            if (!made.padding.empty())
                made.padding[to] = isPadding(measured, low + i) || isPadding(measured, high + i);
        }
    }
    return made;
}

}  // namespace pdr::dicom
