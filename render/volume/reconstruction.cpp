#include "render/volume/reconstruction.h"

#include <algorithm>
#include <cmath>

namespace pdr {

namespace {

constexpr const char* kRemark = "slices interpolated";

/// Computes the slice half-way between slices k and k + 1.
void interpolate(const Volume& volume, int k, std::int16_t* slice) {
    const std::size_t area = std::size_t(volume.size().x) * volume.size().y;
    const HuRange range = volume.storedRange();
    const auto from = [&](int at) { return volume.voxels().data() + area * std::clamp(at, 0, volume.size().z - 1); };
    const std::int16_t *before = from(k - 1), *low = from(k), *high = from(k + 1), *behind = from(k + 2);
    for (std::size_t i = 0; i < area; ++i) {
        const float hu = float(9 * (low[i] + high[i]) - before[i] - behind[i]) / 16;
        slice[i] = std::int16_t(std::clamp(std::lround(hu), long(range.lowest), long(range.highest)));
    }
}

/// Returns which voxels of the finer grid are padding; empty if none is.
std::vector<bool> finerPadding(const Volume& volume) {
    if (volume.paddingCount() == 0)
        return {};
    const std::size_t area = std::size_t(volume.size().x) * volume.size().y;
    std::vector<bool> padding;
    for (int k = 0; k < 2 * volume.size().z - 1; ++k)
        for (std::size_t i = 0; i < area; ++i)
            padding.push_back(volume.isPadding(area * (k / 2) + i) || volume.isPadding(area * ((k + 1) / 2) + i));
    return padding;
}

}  // namespace

Volume reconstructed(Volume volume, Reconstruction reconstruction) {
    const int slices = volume.size().z;
    if (reconstruction == Reconstruction::linear || slices == 1)
        return volume;
    VolumeGeometry geometry = volume.geometry();
    geometry.size.z = 2 * slices - 1;
    geometry.patientFromIndex[2] *= 0.5;
    const std::size_t area = std::size_t(geometry.size.x) * geometry.size.y;
    Voxels voxels(geometry.voxelCount());
    for (int k = 0; k < slices; ++k) {
        std::int16_t* slice = voxels.data() + 2 * area * k;
        std::copy_n(volume.voxels().data() + area * k, area, slice);
        if (k + 1 < slices)
            interpolate(volume, k, slice + area);
    }
    std::string remarks = volume.remarks();
    remarks += (remarks.empty() ? "" : ", ") + std::string(kRemark);
    return Volume(geometry, std::move(voxels), finerPadding(volume), std::move(remarks), volume.hidden());
}

bool hasInterpolatedSlices(const Volume& volume) {
    return volume.remarks().find(kRemark) != std::string::npos;
}

}  // namespace pdr
