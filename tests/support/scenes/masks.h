#pragma once
/// Masks with known answers.

#include <random>

#include "render/volume/mask.h"

namespace pdr::test {

/// Makes a mask with one weight everywhere.
inline std::shared_ptr<const Mask> evenMask(const Volume& volume, int weight, ivec3 shift = ivec3(0)) {
    return maskOf({volume.size(), shift}, "", [weight](dvec3) { return std::int16_t(weight); });
}

/// Makes a random mask: a ball somewhere in the volume, about half its size, with an edge of some voxels; or all
/// but that ball.
inline std::shared_ptr<const Mask> anyMask(const Volume& volume, unsigned seed) {
    std::mt19937 random(seed + 77);
    std::uniform_real_distribution<double> unit(0, 1);
    const dvec3 size(volume.size());
    const dvec3 centre = size * dvec3(unit(random), unit(random), unit(random));
    const double radius = 0.4 * glm::length(size) * (0.3 + 0.7 * unit(random));
    const double side = seed % 2 ? 1 : -1, edge = 0.5 + 6 * unit(random);
    const ivec3 shift(int(random() % 3), int(random() % 3), int(random() % 3));
    return maskOf({volume.size(), shift}, "",
                  [=](dvec3 place) { return edgeWeight(side * (radius - glm::distance(place, centre)), edge); });
}

}  // namespace pdr::test
