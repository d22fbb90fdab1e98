#pragma once
/// Small scenes for each set of effects, and their films: what a second of processor time can render from PTX.

#include "render/device/device_list.h"
#include "render/kernel/features.h"
#include "tests/support/scenes/tissue_scene.h"

namespace pdr::test {

inline constexpr std::uint32_t kSamples = 2;

/// Makes a small scene for which the kernels with these effects are launched.
inline Scene sceneOf(std::uint32_t features) {
    Scene scene = tissueScene();
    scene.film = {16, 12};
    scene.revision = features + 1;
    scene.model = has(features, kBounces) ? Model::multipleScattering : Model::singleScattering;
    scene.maxBounces = 4;
    scene.gradientFactor = has(features, kSurface) ? 2.0f : 0.0f;
    scene.rayOrigin = has(features, kEmission) ? RayOrigin::event : RayOrigin::outsideEdge;
    scene.environment.radiance = vec3(has(features, kEnvironment) ? 0.3f : 0.0f);
    scene.lights = {DirectionalLight{{0.4, 1, -0.5}, vec3(2)}};
    if (has(features, kPlacedLights))
        scene.lights.emplace_back(SphereLight{.centreMm = {200, -300, 100}, .radiance = vec3(30)});
    for (TransferNode& node : scene.transferFunction.nodes)
        node.emission = vec3(has(features, kEmission) ? 0.2f : 0.0f);
    return scene;
}

/// Returns the film after `samples`; null after an error of the device's.
inline std::shared_ptr<const Film> shot(Device& device, const Scene& scene, std::uint32_t samples = kSamples) {
    const auto live = startFilm(device, scene);
    if (!live || !(*live)->accumulate(samples, {}))
        return nullptr;
    const auto film = (*live)->film();
    return film ? *film : nullptr;
}

}  // namespace pdr::test
