#pragma once
/// Rough tissue with surfaces, lit from above and a little from everywhere: most of what a path can encounter, in a
/// small image.

#include "tests/support/scenes/scenes.h"

namespace pdr::test {

inline Scene tissueScene() {
    Scene scene = plainScene(bumpyVolume({50, 41, 37}, {0.9, 1.1, 1.3}, 3), 0.4f);
    scene.transferFunction.nodes = {{.hu = -200, .opacity = 0},
                                    {.hu = 300, .opacity = 0.2f, .albedo = vec3(0.9f, 0.6f, 0.5f)},
                                    {.hu = 900, .opacity = 1, .specular = vec3(0.04f), .roughness = 0.3f}};
    scene.gradientFactor = 2;
    scene.environment.radiance = vec3(0.2f, 0.25f, 0.3f);
    scene.film = {61, 45};
    return scene;
}

}  // namespace pdr::test
