#pragma once
/// Statistics of the HU in a region, and how sure their mean is.

#include <optional>
#include <variant>
#include <vector>

#include "render/base/result.h"
#include "render/volume/volume.h"

namespace pdr::measure {

// Regions: the voxels whose centre lies inside; a border belongs to the inside. Lengths are mm, places patient space.

struct Ball {
    dvec3 centre;
    double radiusMm;
};

/// An ellipse in a plane. The voxels of a plane are those that it passes nearest to: across the grid, one layer.
struct PlaneEllipse {
    dvec3 centre;
    dvec3 halfU, halfV;  ///< its half axes; perpendicular to each other
};

/// A polygon in a plane; where it covers itself, the inside is what an odd number of windings encloses.
struct PlanePolygon {
    std::vector<dvec3> corners;  ///< in order; at least three
    dvec3 normal;                ///< unit vector across the plane, which runs through the first corner
};

using MeasuredShape = std::variant<Ball, PlaneEllipse, PlanePolygon>;

/// Fewest voxels for which the mean has a ±.
inline constexpr std::size_t kFewestForMean = 20;

struct RegionStatistics {
    std::size_t count = 0;         ///< measured voxels: all numbers below are theirs
    std::size_t padding = 0;       ///< voxels inside where the scanner measured nothing
    std::size_t interpolated = 0;  ///< how many of `count` lie in a hole of the scan (render/volume/holes.h)
    bool cut = false;              ///< the region extends beyond the scan; of a region in a plane, its outline
    double millilitres = 0;
    double meanHu = 0, medianHu = 0;
    double sdHu = 0;  ///< with count - 1; 0 for a single voxel
    double lowestHu = 0, highestHu = 0;
    double percentile5 = 0, percentile95 = 0;  ///< linear between the sorted voxels
    /// Half of the 95 % interval of the mean by noise that is correlated as the region's own voxels are, structure
    /// included. None below kFewestForMean voxels.
    std::optional<double> meanPlusMinus;
};

/// Returns the statistics of the voxels in `shape`. Fails if no measured voxel lies inside.
Result<RegionStatistics> regionStatistics(const Volume& volume, const MeasuredShape& shape);

}  // namespace pdr::measure
