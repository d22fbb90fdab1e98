#pragma once
/// The voxels whose centre lies in a shape.

#include "render/measure/region_statistics.h"

namespace pdr::measure {

struct MeasuredVoxels {
    std::vector<ivec3> voxels;  ///< without padding
    std::vector<double> hu;     ///< theirs
    ivec3 low{0}, high{0};      ///< a box that holds them
    std::size_t padding = 0;
    bool cut = false;  ///< the shape extends beyond the scan
};

MeasuredVoxels voxelsIn(const Volume& volume, const MeasuredShape& shape);

/// Returns the thickness of the layer of voxels along a plane with the unit normal `normal` [mm]: every voxel lies in
/// one of such layers side by side.
double layerMm(const VolumeGeometry& geometry, dvec3 normal);

}  // namespace pdr::measure
