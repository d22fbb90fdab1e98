#pragma once
/// Tables for sampling an environment image in proportion to its light; see sampleEnvironment() in
/// kernel/transport/environment.h.

#include <memory>
#include <vector>

#include "render/scene/environment_image.h"

namespace pdr {

struct EnvironmentTables {
    std::shared_ptr<const EnvironmentImage> image;
    std::vector<float> rowSums;     ///< size.y + 1 sums: light of the rows above
    std::vector<float> columnSums;  ///< size.x + 1 sums for each row: light of the texels to the left
    vec3 brightest{0.0f};           ///< highest value of each channel in any texel
    std::vector<float> density;     ///< pdf of each texel's directions when sampled by these sums [1/sr]

    explicit EnvironmentTables(std::shared_ptr<const EnvironmentImage> picture);
};

}  // namespace pdr
