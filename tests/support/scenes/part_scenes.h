#pragma once
/// Scenes whose parts have curves of their own.

#include <functional>
#include <random>

#include "render/scene/scene.h"
#include "tests/support/scenes/random_scenes.h"

namespace pdr::test {

/// Makes a label map of `volume` with the label of each voxel and `count` parts.
inline std::shared_ptr<const LabelMap> labelled(const Volume& volume, int count,
                                                const std::function<int(ivec3)>& label) {
    auto map = std::make_shared<LabelMap>();
    map->geometry = volume.geometry();
    map->labels.resize(map->geometry.voxelCount());
    map->parts.resize(std::size_t(count));
    const ivec3 size = volume.size();
    std::size_t at = 0;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i)
                map->labels[at++] = std::uint8_t(label({i, j, k}));
    return map;
}

/// Makes a label map of blobs: `count` overlapping balls, of which the last one counts.
inline std::shared_ptr<const LabelMap> anyParts(const Volume& volume, int count, unsigned seed) {
    std::mt19937 random(seed + 41);
    std::uniform_real_distribution<double> unit(0, 1);
    const dvec3 size(volume.size());
    struct Ball {
        dvec3 centre;
        double radius;
    };
    std::vector<Ball> balls;
    for (int i = 0; i < count; ++i)
        balls.push_back({size * dvec3(unit(random), unit(random), unit(random)), 2 + 0.3 * size.x * unit(random)});
    return labelled(volume, count, [&](ivec3 voxel) {
        int label = 0;
        for (int i = 0; i < count; ++i)
            if (glm::distance(dvec3(voxel), balls[std::size_t(i)].centre) < balls[std::size_t(i)].radius)
                label = i + 1;
        return label;
    });
}

/// Gives each of the parts of a scene's map a random curve.
inline void giveCurves(Scene& scene, unsigned seed) {
    std::mt19937 random(seed + 5);
    scene.parts.curves.clear();
    for (std::size_t n = 0; n < scene.parts.map->parts.size(); ++n)
        scene.parts.curves.push_back({std::uint8_t(n + 1), anyFunction(random)});
}

}  // namespace pdr::test
