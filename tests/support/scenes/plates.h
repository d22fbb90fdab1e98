#pragma once
/// Thin plates across the view, of which it is known how much light each of them stops.

#include <cmath>
#include <vector>

#include "tests/support/scenes/scenes.h"

namespace pdr::test {

/// A plate one voxel thick. Interpolated between voxels its extinction rises and falls evenly over two voxels.
struct Plate {
    int layer;     ///< layer of the volume along z, from 0
    double depth;  ///< optical depth across the plate; above 0, at most 8
};

/// The optical depth of a plate that stops `share` of the light which `before` has left.
inline double depthFor(double share, double before = 0) {
    return -std::log1p(-share / (1 - before));
}

/// Makes a scene of 8 x 8 x 200 voxels, `spacing` mm apart, seen along -z in parallel projection from 1000 mm above the
/// volume's upper border; a pixel is a voxel wide.
inline Scene platesScene(const std::vector<Plate>& plates, double spacing = 0.5) {
    constexpr int kLayers = 200;
    std::vector<double> hu(kLayers, 0);
    for (const Plate& plate : plates)
        hu[std::size_t(plate.layer)] = std::round(4000 * plate.depth);
    Scene scene =
        plainScene(makeVolume({8, 8, kLayers}, dvec3(spacing), [&](int, int, int k) { return hu[std::size_t(k)]; }),
                   float(8 / spacing));
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}, {.hu = 32000, .opacity = 1}};
    scene.camera = {.type = Camera::Type::orthographic,
                    .eyeMm = spacing * dvec3(4, 4, kLayers) + dvec3(0, 0, 1000),
                    .targetMm = spacing * dvec3(4, 4, 0),
                    .up = {0, 1, 0},
                    .heightMm = 8 * spacing};
    scene.film = {8, 8};
    return scene;
}

/// Returns the height of the middle of a layer of platesScene() [mm].
inline double heightOf(int layer, double spacing = 0.5) {
    return spacing * (layer + 0.5);
}

/// Returns how far in front of a plate's middle the light that stops in it has fallen to `share` of what reaches it
/// [mm]: the extinction rises evenly over one voxel, so that the optical depth up to there is a parabola.
inline double frontOf(double depth, double share, double spacing = 0.5) {
    const double passed = -std::log1p(-share * -std::expm1(-depth));
    const double half = depth / 2;
    return passed <= half ? spacing * (1 - std::sqrt(passed / half))
                          : -spacing * (1 - std::sqrt((depth - passed) / half));
}

}  // namespace pdr::test
