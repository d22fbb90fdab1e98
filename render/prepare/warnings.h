#pragma once
/// Warnings about scenes whose image is known to be wrong before the first sample is taken. Faults of samples are
/// counted in base/health.h.

#include <string>
#include <vector>

#include "render/base/text.h"

namespace pdr {

struct Scene;

struct Warning {
    std::string name;  ///< name in reports: "overDense"
    Text text;         ///< for the user: "2000 free paths between voxels: multiple scattering may be off"
};

/// Number of free paths between neighbouring voxels up to which multiple scattering is accurate to 0.1 %. The limit
/// comes from positions in single precision: at 10 times as many free paths a half space of albedo 0.9 is 2 % too dark,
/// at 100 times 12 %.
inline constexpr double kMostFreePathsPerVoxel = 1000;

/// Returns the warnings about `scene`, which must have passed Scene::check(). overDense: the densest tissue of the
/// volume has more free paths along the largest spacing than multiple scattering supports. Empty if none applies, also
/// for a scene without a volume.
std::vector<Warning> warnings(const Scene& scene);

/// Returns the names of warnings, separated by ", ".
std::string warningNames(const std::vector<Warning>& warnings);

}  // namespace pdr
