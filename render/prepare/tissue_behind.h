#pragma once
/// The tissue behind a place that is seen in the image.

#include "render/prepare/prepared_scene.h"

namespace pdr {

/// The tissue behind a place.
struct TissueBehind {
    float hu;      ///< mean of the first 2 mm behind the place: HU at the edge itself belong to neither side
    float spread;  ///< standard deviation over these 2 mm [HU]
};

/// Returns the tissue behind `placeMm`, in the patient (LPS), along `direction`, a unit vector in the patient's axes.
/// What is cut away is not looked at.
TissueBehind tissueBehind(const PreparedScene& scene, dvec3 placeMm, dvec3 direction);

}  // namespace pdr
