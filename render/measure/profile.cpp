#include "render/measure/profile.h"

#include <cmath>

#include "render/measure/trilinear.h"
#include "render/volume/holes.h"

namespace pdr::measure {
namespace {

/// Returns the shortest distance between two layers of voxels that the line along `direction` meets.
double layerStepMm(const GridPlace& grid, dvec3 direction) {
    const dvec3 index = glm::abs(dmat3(grid.indexFromPatient) * direction);
    return 1 / std::max(index.x, std::max(index.y, index.z));
}

bool touchesPadding(const Volume& volume, const GridPlace& grid, dvec3 mm) {
    bool touches = false;
    eachCorner(grid.size, grid.index(mm),
               [&](ivec3 voxel, double) { touches |= volume.isPadding(grid.offset(voxel)); });
    return touches;
}

}  // namespace

std::vector<ProfileSample> profile(const Volume& volume, dvec3 from, dvec3 to) {
    const GridPlace grid(volume.geometry());
    const double length = glm::distance(from, to);
    const double step = length > 0 ? layerStepMm(grid, (to - from) / length) / 2 : 1;
    const int steps = std::max(1, int(std::ceil(length / step)));
    const std::vector<Hole> holes = holesOf(volume);
    std::vector<ProfileSample> samples;
    for (int n = 0; n <= steps; ++n) {
        const double share = double(n) / steps;
        const dvec3 mm = glm::mix(from, to, share);
        samples.push_back({share * length, huAt(volume, grid, mm),
                           grid.contains(mm) && !touchesPadding(volume, grid, mm), reachesInto(holes, mm, mm)});
    }
    return samples;
}

}  // namespace pdr::measure
