#include "render/prepare/warnings.h"

#include "render/prepare/met_tissue.h"
#include "render/scene/range.h"
#include "render/scene/scene.h"

namespace pdr {

std::vector<Warning> warnings(const Scene& scene) {
    if (!scene.volume || scene.model != Model::multipleScattering || scene.maxBounces == 1)
        return {};
    const dvec3 spacing = scene.volume->geometry().spacingMm();
    const double freePaths = MetTissue(scene.transferFunction, *scene.volume).highestExtinction() *
                             glm::max(spacing.x, glm::max(spacing.y, spacing.z));
    if (freePaths <= kMostFreePathsPerVoxel)
        return {};
    return {{"overDense", numberText(freePaths, 3) + " free paths between voxels, above " +
                              numberText(kMostFreePathsPerVoxel) + " multiple scattering comes out wrong"}};
}

std::string warningNames(const std::vector<Warning>& warnings) {
    std::string names;
    for (const Warning& warning : warnings)
        names += (names.empty() ? "" : ", ") + warning.name;
    return names;
}

}  // namespace pdr
