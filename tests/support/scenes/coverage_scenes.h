#pragma once
/// Scenes whose light is easy or hard to find, on which tests verify the stated error of an image.

#include "render/scene/named_look.h"
#include "tests/support/scenes/tissue_scene.h"

namespace pdr::test {

inline Scene tissueThroughALens() {
    Scene scene = tissueScene();
    scene.camera.apertureMm = 12;
    return scene;
}

inline Scene tissueFromOutsideItsEdges() {
    Scene scene = tissueScene();
    scene.rayOrigin = RayOrigin::outsideEdge;
    return scene;
}

inline Scene forwardFog() {
    Scene scene = plainScene(bumpyVolume({40, 40, 40}, dvec3(2), 5), 0.1f);
    scene.transferFunction.nodes = {{.hu = -600, .opacity = 0.05f, .albedo = vec3(0.95f)},
                                    {.hu = 600, .opacity = 1, .albedo = vec3(0.95f)}};
    scene.model = Model::multipleScattering;
    scene.phaseG = 0.9f;
    return scene;
}

inline Scene smallBrightLamp() {
    Scene scene = tissueScene();
    const dvec3 centre = scene.volume->geometry().centreMm();
    scene.environment = {};
    scene.lights = {SphereLight{centre + dvec3(5, -60, 40), 1, vec3(3000)}};
    return scene;
}

inline Scene manyBounces() {
    Scene scene = tissueScene();
    scene.model = Model::multipleScattering;
    return scene;
}

/// Function that makes one of these scenes.
using MakeScene = Scene (*)();

}  // namespace pdr::test
