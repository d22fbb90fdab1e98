#pragma once
/// Where the highest HU on a ray lies: what a point of a maximum intensity projection shows.

#include <optional>

#include "render/kernel/flat_scene.h"
#include "render/kernel/ray.h"

namespace pdr {

/// The highest HU on a ray, and its distance from the ray's origin [mm]; the nearest of equals.
struct HighestAlong {
    float hu;
    float alongMm;
};

/// Finds the highest visible HU on `ray`, at nine places of each cell between voxels that the ray crosses; none if
/// everything on it is hidden. `scene` must have been prepared for maximumIntensity. As in the image, tissue with a
/// visibility weight below one half counts as hidden.
std::optional<HighestAlong> highestAlong(const FlatScene& scene, const Ray& ray);

}  // namespace pdr
