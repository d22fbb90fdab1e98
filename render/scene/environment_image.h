#pragma once
/// An image of the environment that can light a scene. Its projection is latitude-longitude, with rows from the zenith
/// down; kernel/transport/environment.h defines how it is oriented about the patient.

#include <vector>

#include "render/base/portable.h"
#include "render/base/result.h"

namespace pdr {

struct EnvironmentImage {
    ivec2 size{0};             ///< texels; each in [1, kLongestSide]
    std::vector<vec3> texels;  ///< linear Rec. 709 radiance, row by row; each in [0, 1e30]

    /// Checks the ranges above and the number of texels. `where` of the error names the side or the first texel out of
    /// range.
    Result<void> check() const;
};

}  // namespace pdr
