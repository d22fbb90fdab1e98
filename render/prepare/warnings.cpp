#include "render/prepare/warnings.h"

#include "render/prepare/met_tissue.h"
#include "render/scene/scene.h"

namespace pdr {

std::vector<Warning> warnings(const Scene& scene) {
    if (!scene.volume || scene.model != Model::multipleScattering || scene.maxBounces == 1)
        return {};
    const dvec3 spacing = scene.volume->geometry().spacingMm();
    const double freePaths = MetTissue(scene).highestExtinction() * glm::max(spacing.x, glm::max(spacing.y, spacing.z));
    if (freePaths <= kMostFreePathsPerVoxel)
        return {};
    return {{"overDense", phrase("%1 free paths between voxels, above %2 multiple scattering comes out wrong",
                                 numberOf(freePaths, 3), numberOf(kMostFreePathsPerVoxel))}};
}

std::string warningNames(const std::vector<Warning>& warnings) {
    std::string names;
    for (const Warning& warning : warnings)
        names += (names.empty() ? "" : ", ") + warning.name;
    return names;
}

}  // namespace pdr
