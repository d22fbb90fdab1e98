#include "render/prepare/tissue_behind.h"

#include <algorithm>
#include <cmath>

#include "render/kernel/clip.h"
#include "render/kernel/volume_sampling.h"

namespace pdr {

TissueBehind tissueBehind(const PreparedScene& scene, dvec3 placeMm, dvec3 direction) {
    constexpr int kPlaces = 16;
    constexpr float kThickMm = 2;
    const FlatVolume& volume = scene.flat.volume;
    const vec3 origin(glm::inverse(scene.volume->geometry().patientFromIndex) * dvec4(placeMm, 1));
    const vec3 perMm(volume.exactIndexFromLocal * direction);
    const float thick = std::max(cutLength(scene.flat.clip, origin, perMm, kThickMm), 0.0f);
    double sum = 0, squares = 0;
    for (int i = 0; i < kPlaces; ++i) {
        const float along = thick * (float(i) + 0.5f) / kPlaces;
        const auto hu = double(interpolatedHounsfield(volume, origin + perMm * along));
        sum += hu;
        squares += hu * hu;
    }
    const double mean = sum / kPlaces;
    return {float(mean), float(std::sqrt(std::max(squares / kPlaces - mean * mean, 0.0)))};
}

}  // namespace pdr
