#pragma once
/// What finding the light of a picture of the surroundings needs; see sampleEnvironment() in kernel/environment.h.

#include <memory>
#include <vector>

#include "render/scene/environment_image.h"

namespace pdr {

struct EnvironmentTables {
    std::shared_ptr<const EnvironmentImage> image;
    std::vector<float> rowSums;     ///< size.y + 1: light of the rows above
    std::vector<float> columnSums;  ///< size.x + 1 for each row: light of the texels to the left
    vec3 brightest{0.0f};           ///< no texel is brighter
    std::vector<float> density;     ///< of each texel's directions [1/sr], as the two tables above find them

    explicit EnvironmentTables(std::shared_ptr<const EnvironmentImage> picture);
};

}  // namespace pdr
