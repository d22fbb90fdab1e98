#pragma once
/// HU along a straight line, as slices show them.

#include <vector>

#include "render/measure/place.h"

namespace pdr::measure {

/// A sample of a profile.
struct ProfileSample {
    double mm;  ///< distance from the beginning of the line
    double hu;
    bool measured;            ///< false outside the scan, and where the scanner measured nothing
    bool acrossHole = false;  ///< whether the HU depend on slices in a hole of the scan (render/volume/holes.h)
};

/// Samples the line at equal distances, at most half of what lies between two layers of voxels along it, both ends
/// included: no voxel that it passes is left out. At least two samples; both the same if the line has no length.
std::vector<ProfileSample> profile(const Volume& volume, dvec3 from, dvec3 to);

}  // namespace pdr::measure
