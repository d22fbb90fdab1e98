#pragma once
/// What is known to make a picture of a scene wrong before its first sample is taken. Counts of what went wrong with
/// samples are another thing: base/health.h.

#include <string>
#include <vector>

#include "render/base/text.h"

namespace pdr {

struct Scene;

struct Warning {
    std::string name;  ///< its word in reports: "overDense"
    Text text;         ///< for the user: "2000 free paths between voxels: multiple scattering may be off"
};

/// Up to so many free paths between neighbouring voxels multiple scattering is right to 0.1 %. Places are single
/// precision: at 10 times as many a half space of albedo 0.9 is 2 % too dark, at 100 times 12 %.
inline constexpr double kMostFreePathsPerVoxel = 1000;

/// overDense: the densest tissue that the volume holds has more free paths along its largest spacing than multiple
/// scattering stands. Empty: nothing is known, as of a scene without a volume. `scene` must have passed Scene::check().
std::vector<Warning> warnings(const Scene& scene);

/// Their names, ", " in between.
std::string warningNames(const std::vector<Warning>& warnings);

}  // namespace pdr
