#pragma once
/// The layers of tissue in which the light under a point of an image stops. In a translucent look it stops at several
/// depths, and half of it may lie where nothing is; a layer is a short stretch of the ray that holds much of the light.

#include <vector>

#include "render/prepare/first_events.h"

namespace pdr {

struct LightLayer {
    double alongMm;    ///< median of the light that stops in the layer, from the ray's origin [mm]
    double sigmaMm;    ///< half the width along the ray that holds the 16th to the 84th per cent of that light [mm]
    double share;      ///< share of all light under the point, that which passes included; (0, 1]
    double nearShare;  ///< share of all light that stops within 1 mm of the median; (0, 1]
};

/// Returns how far apart the voxels are along a ray [mm]: 1 / sqrt(sum (n_i / spacing_i)^2), the width of the ellipsoid
/// that fits into a voxel.
double spacingAlong(const Ray& ray);

/// Returns the length of a layer on a ray [mm]: 2 mm, or 1.5 voxels where these are longer, since no edge in the scan
/// is shorter.
double layerWindowMm(const Ray& ray);

/// Returns the layers that hold at least a tenth of all light, heaviest first. Each is layerWindowMm() long; the light
/// in them is at least 3 mm apart, and no part of the ray belongs to two of them. `quantiles`: how many distances the
/// layers are looked for at, at least 10; the heaviest layer may be missed by two of their steps.
std::vector<LightLayer> lightLayers(const FirstEvents& events, int quantiles);

}  // namespace pdr
