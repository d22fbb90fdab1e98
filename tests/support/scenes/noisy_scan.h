#pragma once
/// Scans of phantoms by formula.

#include <cmath>
#include <random>

#include "render/volume/volume.h"

namespace pdr::test {

/// Returns a scan of hu(place in mm): each voxel is the mean of 8 places, with normally distributed noise of `noiseHu`,
/// the same at every call.
template <class Hu>
Volume noisyScan(const VolumeGeometry& geometry, double noiseHu, const Hu& hu) {
    std::mt19937 random(20261127);
    std::normal_distribution<double> noise(0, noiseHu);
    Voxels voxels;
    for (int z = 0; z < geometry.size.z; ++z)
        for (int y = 0; y < geometry.size.y; ++y)
            for (int x = 0; x < geometry.size.x; ++x) {
                double sum = 0;
                for (int part = 0; part < 8; ++part) {
                    const dvec3 off(part & 1 ? 0.25 : -0.25, part & 2 ? 0.25 : -0.25, part & 4 ? 0.25 : -0.25);
                    sum += hu(dvec3(geometry.patientFromIndex * dvec4(dvec3(x, y, z) + off, 1)));
                }
                voxels.push_back(std::int16_t(std::lround(sum / 8 + noise(random))));
            }
    return Volume(geometry, std::move(voxels));
}

}  // namespace pdr::test
