#pragma once
/// A picture of the surroundings, by which a scene can be lit: latitude-longitude, rows from the zenith down; see
/// kernel/environment.h for how it lies about the patient.

#include <vector>

#include "render/base/portable.h"
#include "render/base/result.h"

namespace pdr {

struct EnvironmentImage {
    ivec2 size{0};             ///< texels; each in [1, kLongestSide]
    std::vector<vec3> texels;  ///< linear Rec. 709 radiance, row by row; each in [0, 1e30]

    /// `where` names the first texel that is no light.
    Result<void> check() const;
};

}  // namespace pdr
